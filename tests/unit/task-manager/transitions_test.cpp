// The declared transitions against the procedure: FakeRobot lets none pass that is not declared; here each that is
// declared is seen.

#include "common/task/transitions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

struct NeverSeen {
  Phase from;
  Phase to;
  const char* why;
};

constexpr NeverSeen kNeverSeen[] = {
    {Phase::kHoldLifted, Phase::kFailed, "the way down to its place goes by postures that the arm came up through"},
};

constexpr Phase kAtWork[] = {Phase::kDrive,   Phase::kLook,  Phase::kApproach, Phase::kServo,
                             Phase::kGrip,    Phase::kLift,  Phase::kVerify,   Phase::kLiftOn,
                             Phase::kRelease, Phase::kCarry, Phase::kGoHome};
constexpr Phase kEmptyHanded[] = {Phase::kIdle, Phase::kDone, Phase::kRefused, Phase::kFailed, Phase::kStopped};

const geometry::PlanePose kDock{0.2, 1.05, M_PI / 2};
const StopReport kStop{true, true, "arm: stop from test"};

// Gives stale input up before anything else does.
FakeRobot impatient_robot() {
  Parameters parameters;
  parameters.motion.stale_timeout = 0.2;
  return FakeRobot(default_robot(), parameters);
}

class DeclaredTransition : public ::testing::Test {
 protected:
  // Runs until `phase`, which must come.
  void go_on(FakeRobot& robot, Phase phase, double seconds = 60.0) {
    EXPECT_TRUE(robot.run_until(phase, seconds))
        << "to " << name_of(phase) << ", but it is " << name_of(robot.last().phase) << ": " << robot.last().reason;
    for (std::size_t i = 1; i < robot.phases().size(); ++i) seen_.emplace(robot.phases()[i - 1], robot.phases()[i]);
  }

  FakeRobot at_work_in(Phase phase) {
    FakeRobot robot = impatient_robot();
    robot.p_CT.x() = -0.0175;  // the hand comes into view among the spines only: there is a way to back off
    if (phase == Phase::kDrive) {
      robot.send_drive(kDock);
    } else {
      robot.send(CommandKind::kStart, "red_book", phase != Phase::kHoldLifted);
    }
    go_on(robot, phase);
    return robot;
  }

  FakeRobot empty_handed_in(Phase phase) {
    FakeRobot robot;
    robot.frame();
    if (phase == Phase::kDone) robot.send(CommandKind::kHome);
    if (phase == Phase::kRefused) robot.send(CommandKind::kStart, "green_book");
    if (phase == Phase::kFailed || phase == Phase::kStopped) {
      robot.base_answers = phase != Phase::kFailed;
      robot.send_drive(kDock);
      robot.frame();
    }
    if (phase == Phase::kStopped) robot.send(CommandKind::kAbort);
    go_on(robot, phase);
    robot.base_answers = true;
    return robot;
  }

  void see_what_goes_well();
  void see_what_is_not_taken();
  void see_marks_lost_at_work();
  void see_work_ended();
  void see_commands_with_an_empty_hand();
  void see_commands_with_a_full_hand();

  std::set<std::pair<Phase, Phase>> seen_;
};

void DeclaredTransition::see_what_goes_well() {
  at_work_in(Phase::kDone);
  FakeRobot driven_only;
  driven_only.base_pose.y = 0.05;
  driven_only.send_drive_only(kDock);
  go_on(driven_only, Phase::kDone);
  FakeRobot lifted = at_work_in(Phase::kHoldLifted);
  lifted.send(CommandKind::kHome);
  go_on(lifted, Phase::kDone);
  FakeRobot second_grip;
  second_grip.slips = 1;
  second_grip.send(CommandKind::kStart, "red_book");
  go_on(second_grip, Phase::kHoldLifted);
  FakeRobot driven_nearer;
  driven_nearer.p_CT.y() = 1.25;
  driven_nearer.base_drift = 0.10;
  driven_nearer.send_drive(kDock);
  go_on(driven_nearer, Phase::kApproach);
}

void DeclaredTransition::see_what_is_not_taken() {
  FakeRobot unseen;
  unseen.target_sight = Sight::kUnseen;
  unseen.send(CommandKind::kStart, "red_book");
  go_on(unseen, Phase::kRefused);
  FakeRobot unseen_from_the_dock;
  unseen_from_the_dock.target_sight = Sight::kUnseen;
  unseen_from_the_dock.send_drive(kDock);
  go_on(unseen_from_the_dock, Phase::kFailed);
  FakeRobot without_stop_device;
  without_stop_device.stop.known = false;
  without_stop_device.send_drive(kDock);
  go_on(without_stop_device, Phase::kRefused);
}

void DeclaredTransition::see_marks_lost_at_work() {
  for (const Phase phase : {Phase::kApproach, Phase::kServo, Phase::kGrip}) {
    SCOPED_TRACE(name_of(phase));
    FakeRobot robot = at_work_in(phase);
    robot.hand_sight = Sight::kUnseen;
    go_on(robot, Phase::kRelease);
    go_on(robot, Phase::kFailed);
  }
}

void DeclaredTransition::see_work_ended() {
  for (const Phase phase : kAtWork) {
    SCOPED_TRACE(name_of(phase));
    FakeRobot stopped = at_work_in(phase);
    stopped.stop = kStop;
    go_on(stopped, Phase::kStopped, 0.1);
    if (phase == Phase::kLook) continue;  // nothing moves: it may wait
    FakeRobot failed = at_work_in(phase);
    failed.stale = true;
    failed.target_sight = Sight::kUnseen;
    go_on(failed, Phase::kFailed, 0.5);
  }
}

void DeclaredTransition::see_commands_with_an_empty_hand() {
  const robot::JointVector beyond_the_shoulders_limit(0.0, -0.5, -0.5);
  for (const Phase phase : kEmptyHanded) {
    for (const Phase next :
         {Phase::kLook, Phase::kDrive, Phase::kRefused, Phase::kGoHome, Phase::kStopped, Phase::kFailed}) {
      if (next == phase) continue;
      SCOPED_TRACE(std::string(name_of(phase)) + " to " + name_of(next));
      FakeRobot robot = empty_handed_in(phase);
      if (next == Phase::kStopped) robot.stop = kStop;
      if (next == Phase::kFailed) robot.push_arm_to(beyond_the_shoulders_limit);
      if (next == Phase::kLook) {
        robot.send(CommandKind::kStart, "red_book");
      } else if (next == Phase::kDrive) {
        robot.send_drive(kDock);
      } else if (next == Phase::kRefused) {
        robot.send(CommandKind::kStart, "green_book");
      } else {
        robot.send(CommandKind::kHome);
      }
      go_on(robot, next, 0.1);
    }
  }
}

void DeclaredTransition::see_commands_with_a_full_hand() {
  FakeRobot refused = at_work_in(Phase::kHoldLifted);
  refused.send(CommandKind::kStart, "red_book");
  go_on(refused, Phase::kRefused, 0.1);
  FakeRobot stopped = at_work_in(Phase::kHoldLifted);
  stopped.stop = kStop;
  go_on(stopped, Phase::kStopped, 0.1);
  stopped.stop = {true, false, ""};
  FakeRobot failed = at_work_in(Phase::kLiftOn);
  failed.stale = true;
  go_on(failed, Phase::kFailed, 0.5);
  failed.stale = false;
  for (FakeRobot* robot : {&refused, &stopped, &failed}) {
    SCOPED_TRACE(name_of(robot->last().phase));
    robot->send(CommandKind::kHome);
    go_on(*robot, Phase::kRelease, 0.1);
  }
}

TEST_F(DeclaredTransition, IsSeenInSomeTaskOrCannotBe) {
  see_what_goes_well();
  see_what_is_not_taken();
  see_marks_lost_at_work();
  see_work_ended();
  see_commands_with_an_empty_hand();
  see_commands_with_a_full_hand();
  for (const TaskTransition& row : kTaskTransitions) {
    const auto never = std::find_if(std::begin(kNeverSeen), std::end(kNeverSeen), [&](const NeverSeen& other) {
      return other.from == row.from && other.to == row.to;
    });
    EXPECT_NE(seen_.count({row.from, row.to}) > 0, never != std::end(kNeverSeen))
        << name_of(row.from) << " to " << name_of(row.to) << ", " << row.when
        << (never != std::end(kNeverSeen) ? std::string(": seen, though ") + never->why : ": never seen");
  }
}

}  // namespace
}  // namespace markservo::task_manager
