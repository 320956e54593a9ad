// Before figure 11: the base brings the robot to where it can take the target, and stands from then on.

#include <cstdio>

#include "services/task-manager/procedure_step.hpp"

namespace markservo::task_manager {
namespace {

// Stages of Phase::kDrive.
constexpr int kReady = 0;    // waiting for the first word of the arm and the stop devices
constexpr int kFolding = 1;  // the arm comes home: stretched out, it would hit what no sonar sees
constexpr int kDriving = 2;
constexpr int kStanding = 3;  // arrived

constexpr double kPointlessCorrection = 0.01;  // m: the target stands as wished, and still cannot be taken

std::string words_of(const geometry::PlanePose& pose) {
  char text[96];
  std::snprintf(text, sizeof text, "x %.2f m, y %.2f m, %.0f degrees", pose.x, pose.y, geometry::degrees(pose.heading));
  return text;
}

}  // namespace

void ProcedureStep::drive() {
  switch (s_.stage) {
    case kReady:
      return make_ready();
    case kFolding:
      return way_is_done() ? drive_to(false, *s_.task.drive_pose) : void();
    case kDriving:
      return watch_the_drive();
    default:
      if (waited() < p_.drive.settle_time) return;
      s_.target_mean = MarkAverage();
      return enter(Phase::kLook, "looking for the mark of " + s_.task.target);
  }
}

bool ProcedureStep::may_drive() const {
  return s_.phase == Phase::kDrive && s_.stage == kDriving;
}

bool ProcedureStep::waits_for_first_word() const {
  return (s_.phase == Phase::kLook && s_.attempt == 1) || (s_.phase == Phase::kDrive && s_.stage == kReady);
}

void ProcedureStep::make_ready() {
  if (!in_.arm || !in_.stop.known) {
    if (waited() > p_.look.timeout) not_taken(who_is_silent());
    return;
  }
  if ((in_.arm->q - arm().home).cwiseAbs().maxCoeff() <= p_.drive.home_tolerance) {
    return drive_to(false, *s_.task.drive_pose);
  }
  const PosturePath path = plan_home(arm(), p_, {in_.arm->q, in_.arm->gripper_opening});
  if (!path.reachable()) return not_taken(std::string("no way home: ") + robot::describe(path.status()));
  enter_stage(kFolding, "folding the arm for the drive");
  play(path.moves());
}

void ProcedureStep::drive_to(bool from_robot, const geometry::PlanePose& pose) {
  enter_stage(kDriving, (from_robot ? "driving on by " : "driving to ") + words_of(pose));
  s_.drive.driven = true;
  s_.drive.words = s_.reason;
  s_.drive.progress = begin_of_drive(in_.utime);
  DriveGoal goal;
  goal.drive = true;
  goal.from_robot = from_robot;
  goal.pose = pose;
  goal.clearance = p_.drive.clearance;
  goal.speed = p_.drive.speed;
  send(goal);
}

void ProcedureStep::watch_the_drive() {
  const DriveReport report = watch_drive(s_.drive.goal.id, in_, p_.drive, s_.drive.progress);
  switch (report.state) {
    case DriveState::kUnderWay:
      s_.reason = s_.drive.words;
      return;
    case DriveState::kWaiting:
      s_.reason = s_.drive.words + "; " + report.reason;
      return;
    case DriveState::kArrived:
      return enter_stage(kStanding, "arrived");
    case DriveState::kFailed:
      return fail(report.reason);
    case DriveState::kStopped:
      return stop(report.reason);
  }
}

// The target is seen at s_.p_CT, where it cannot be taken: true if the base drives on, so that it will be in the middle
// of the workspace.
bool ProcedureStep::corrects_the_stand(const std::string& trouble) {
  if (!s_.drive.driven || s_.attempt > 1 || s_.drive.corrections >= p_.drive.corrections) return false;
  const Eigen::Vector2d off = s_.p_CT.head<2>() - Eigen::Vector2d(arm().p_CA.x(), p_.drive.target_depth);
  if (off.norm() < kPointlessCorrection || off.norm() > p_.drive.correction_max) return false;
  ++s_.drive.corrections;
  out_.notices.push_back("driving nearer, since " + trouble);
  enter(Phase::kDrive, "");
  // R's axes are C's: its x is C's y, its y is C's -x.
  drive_to(true, {off.y(), -off.x(), 0.0});
  return true;
}

void ProcedureStep::send(DriveGoal goal) {
  goal.id = s_.drive.numbers.next(s_.drive.goal.id);
  s_.drive.goal = goal;
  s_.drive.goal_is_new = true;
}

// The base stands whenever it is not driving for the task: the arm works, or nothing is known of what is around.
void ProcedureStep::command_the_base() {
  if (!robot_.base) return;
  if (!may_drive() && (s_.drive.goal.drive || s_.drive.goal.id == 0)) send(DriveGoal());
  if (!s_.drive.goal_is_new && !s_.drive.repeat.due(in_.utime)) return;
  s_.drive.repeat.restart(in_.utime);
  s_.drive.goal_is_new = false;
  out_.drive_goal = s_.drive.goal;
}

}  // namespace markservo::task_manager
