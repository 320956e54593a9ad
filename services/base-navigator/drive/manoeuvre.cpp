#include "services/base-navigator/drive/manoeuvre.hpp"

#include <cmath>

namespace markservo::base_navigator {

using geometry::PlanePose;

Advice Manoeuvre::step(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const {
  const PoseError error = error_of(situation.X_WR, goal.X_WG);
  if (state.phase == Phase::kArrived && has_left(parameters_.arrival, error)) state = ManoeuvreState();
  state.room.count(situation, state.phase == Phase::kTurnToCourse || state.phase == Phase::kTurnToHeading);
  if (state.phase == Phase::kPlan) plan(situation, goal, state);
  switch (state.phase) {
    case Phase::kTurnToCourse: {
      const double off_course = course_of(parameters_.drive, state.leg, situation).heading_error;
      if (std::abs(off_course) > parameters_.turn.done) return turn(situation, goal, off_course, state);
      state.phase = Phase::kDrive;
      return drive(situation, goal, state);
    }
    case Phase::kDrive:
      return drive(situation, goal, state);
    case Phase::kTurnToHeading:
      if (std::abs(error.heading) > parameters_.turn.done) return turn(situation, goal, error.heading, state);
      state.phase = Phase::kSettle;
      return settle(situation, goal, state);
    case Phase::kSettle:
      return settle(situation, goal, state);
    case Phase::kArrived:
      return {stand(), DriveState::kArrived, ""};
    case Phase::kPlan:
    case Phase::kGivenUp:
      break;
  }
  return {stand(), DriveState::kHold, state.arrival.why_given_up()};
}

void Manoeuvre::interrupt(ManoeuvreState& state) {
  state.arrival.interrupt();
  state.passage = PassageState();
  if (state.phase != Phase::kArrived && state.phase != Phase::kGivenUp) state.phase = Phase::kPlan;
}

void Manoeuvre::plan(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const {
  const LegParameters& legs = parameters_.legs;
  const double look = legs.near + legs.back_off;
  const double behind = guard_.straight_room(situation, goal.clearance, Direction::kBackward, look);
  const double ahead = guard_.straight_room(situation, goal.clearance, Direction::kForward, look);
  const bool docking = goal.clearance < legs.docking_below;
  const LegPlan plan = plan_leg(legs, situation.X_WR, goal.X_WG, docking, state.staged, behind, ahead);
  state.passage = PassageState();
  if (plan.there) {
    state.phase = Phase::kTurnToHeading;
    return;
  }
  state.leg = plan.leg;
  const double off_course = course_of(parameters_.drive, state.leg, situation).heading_error;
  state.phase = std::abs(off_course) > parameters_.turn.first ? Phase::kTurnToCourse : Phase::kDrive;
}

Advice Manoeuvre::turn(const Situation& situation, const Assignment& goal, double angle, ManoeuvreState& state) const {
  const GuardedTurn turn = turn_on_spot(guard_, situation, goal.clearance, angle, state.passage);
  if (!turn.passage.blocked) return advice_of(turn.passage);
  const PoseError error = error_of(situation.X_WR, goal.X_WG);
  if (state.phase == Phase::kTurnToHeading && coarsely_there(parameters_.arrival, error)) {
    state.phase = Phase::kSettle;
    return settle(situation, goal, state);
  }
  const auto room =
      state.room.step(parameters_.turn, guard_, situation, goal.clearance, turn, state.arrival.corrections());
  return room ? *room : advice_of(turn.passage);
}

Advice Manoeuvre::drive(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const {
  const LegStep step = drive_leg(parameters_.drive, guard_, situation, goal, state.leg, state.passage);
  switch (step.progress) {
    case LegProgress::kUnderWay:
      break;
    case LegProgress::kBlocked:
      if (!ends_at_obstacle(situation, goal, state)) return advice_of(step.passage);
      state.leg.to_goal = true;
      end_leg(state);
      break;
    case LegProgress::kEnded:
      end_leg(state);
      break;
    case LegProgress::kOffCourse:
      state.phase = Phase::kPlan;
      break;
  }
  return {step.passage.motion, DriveState::kDriving, ""};
}

// Blocked at the goal itself: near enough, or the trouble is how the robot stands, and a correction mends that.
bool Manoeuvre::ends_at_obstacle(const Situation& situation, const Assignment& goal,
                                 const ManoeuvreState& state) const {
  const ArrivalParameters& arrival = parameters_.arrival;
  const PoseError error = error_of(situation.X_WR, goal.X_WG);
  if (coarsely_there(arrival, error)) return true;
  const PlanePose X_GR = goal.X_WG.inverse() * situation.X_WR;
  const bool aligned = std::abs(X_GR.y) <= parameters_.legs.beside_within && std::abs(error.heading) <= arrival.heading;
  return !aligned && error.distance <= parameters_.obstacle_at_goal &&
         state.arrival.corrections() < arrival.corrections;
}

void Manoeuvre::end_leg(ManoeuvreState& state) {
  state.passage = PassageState();
  if (state.leg.to_goal) {
    state.phase = Phase::kTurnToHeading;
  } else {
    state.staged = true;
    state.phase = Phase::kPlan;
  }
}

Advice Manoeuvre::settle(const Situation& situation, const Assignment& goal, ManoeuvreState& state) const {
  const PoseError error = error_of(situation.X_WR, goal.X_WG);
  switch (state.arrival.judge(parameters_.arrival, situation, error)) {
    case Arrival::Verdict::kWaits:
      break;
    case Arrival::Verdict::kArrived:
      state.phase = Phase::kArrived;
      return {stand(), DriveState::kArrived, ""};
    case Arrival::Verdict::kCorrects:
      state.phase = Phase::kPlan;
      break;
    case Arrival::Verdict::kWillDo:
      state.phase = Phase::kArrived;
      break;
    case Arrival::Verdict::kGivesUp:
      state.phase = Phase::kGivenUp;
      break;
  }
  return {stand(), DriveState::kDriving, ""};
}

}  // namespace markservo::base_navigator
