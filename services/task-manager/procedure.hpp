#pragma once

// The task's procedure (paper fig. 11) as a state machine: one step per SERVO_STATUS, time from its utime.
//
//   IDLE -> LOOK -> APPROACH -> SERVO -> GRIP -> LIFT -> VERIFY -> LIFT_ON -> HOLD_LIFTED
//             |                    ^                        |          '-> CARRY -> RELEASE -> GO_HOME -> DONE
//             v                    '-- LOOK <- RELEASE <----'  once, when the object did not come along
//          REFUSED               any -> FAILED; STOP or ABORT: any -> STOPPED
//
// A task with a pose to drive to begins with DRIVE: the arm folds, the base drives, the robot stands a moment. When
// LOOK then finds the target where it cannot be taken, DRIVE brings the robot nearer, a few times. In every other
// phase, and without a task, the base is told to hold.
//
// Commands: each is executed once, START and HOME only while fresh by the arm's time. START and HOME while a task is
// running are answered and ignored, with a notice; ABORT ends any task where the arm is. HOME with an object held over
// its place puts it back first; START is refused while the hand holds one. After STOP a new START is needed. In every
// end state the gripper stays as the arm reports it, so that no reset makes it go on; one that holds something keeps
// pressing. After a restart it is unknown whether it holds something: a hand that is not open stays closed with the
// grip's force until HOME or START opens it.

#include <memory>

#include "common/bus/repeat_timer.hpp"
#include "common/motion/command_inbox.hpp"
#include "services/task-manager/drive_watch.hpp"
#include "services/task-manager/goal_numbers.hpp"
#include "services/task-manager/lift_check.hpp"
#include "services/task-manager/move_watch.hpp"
#include "services/task-manager/parameters.hpp"
#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

// What the hand holds, as far as the procedure knows.
struct Holding {
  bool something = false;
  bool over_place = false;  // lifted straight from where it stood: it can be put back
  bool let_go = false;      // the hand was told to open: whether it still holds is not known
  std::int64_t arm_session = 0;
  robot::JointVector q = robot::JointVector::Zero();  // rad, when last told to move
};

// What follows when a RELEASE is done.
enum class AfterRelease { kLookAgain, kFail, kHome, kHomeCarried };

// What the base was told for the task, and how that goes.
struct DriveTask {
  DriveGoal goal;
  GoalNumbers numbers;
  DriveProgress progress;
  std::string words;  // where to, for people
  bus::RepeatTimer repeat{bus::kStateRepeat_us};
  int corrections = 0;  // drives after the first
  bool goal_is_new = false;
  bool driven = false;  // the base was told to drive for this task
  std::optional<std::int64_t> unanswered_since;
};

struct State {
  Phase phase = Phase::kIdle;
  int attempt = 0;
  Result result = Result::kNone;
  std::string reason = "started: no task";
  Command task;  // the last START
  motion::CommandInbox inbox{"TASK_COMMAND", "JOINT_STATE"};

  Goal goal;
  GoalNumbers numbers;
  bool goal_is_new = false;
  bus::RepeatTimer repeat{bus::kStateRepeat_us};

  DriveTask drive;

  int stage = 0;                // within a phase
  std::int64_t since = 0;       // us, begin of the stage
  std::int64_t seen_utime = 0;  // us, when what the stage waits for was last seen
  std::optional<std::int64_t> lost_since, stale_since, stopped_since, unheard_since;
  std::optional<std::int64_t> arm_unanswered_since;

  std::vector<Move> moves;  // the way that is gone, and how far
  std::size_t move_index = 0;
  MoveProgress move_progress;

  int hand_frames = 0;  // located in a row
  std::int64_t pose_utime = 0;
  MarkAverage target_mean, hand_mean;
  Eigen::Vector3d p_CT = Eigen::Vector3d::Zero();        // m, as looked at
  Eigen::Vector3d p_CG_first = Eigen::Vector3d::Zero();  // m, where the hand backs off to
  double standoff = 0.0;                                 // m
  double check_height = 0.0;                             // m
  LiftView before;                                       // at the grip
  Holding holding;
  AfterRelease after_release = AfterRelease::kFail;
  std::string failure;  // told when a RELEASE ends in FAILED

  bool stop_was_latched = false;
  bool stop_was_known = false;
  std::int64_t arm_session = 0;
  std::int64_t utime = 0;  // us, of the step before
};

class Procedure {
 public:
  Procedure(robot::RobotDescription robot, Parameters parameters);
  Output step(const Input& input, State& state) const;

 private:
  robot::RobotDescription robot_;
  Parameters parameters_;
};

}  // namespace markservo::task_manager
