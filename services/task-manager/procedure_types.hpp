#pragma once

// What the procedure is told and what it answers: plain structs behind lcmtypes. SI units, rad, camera frame C, the
// floor's W for the base; utime in us of measurement.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "common/states/base_state.hpp"
#include "common/states/mark_status.hpp"
#include "common/states/servo_state.hpp"
#include "common/states/task_phase.hpp"

namespace markservo::task_manager {

using Phase = TaskPhase;
using Result = TaskResult;
using Sight = MarkStatus;

enum class CommandKind { kStart, kAbort, kHome, kDrive };

struct Command {
  std::int64_t session = 0;
  std::int64_t id = 0;
  std::int64_t utime = 0;  // us, as the sender last heard the task's time
  CommandKind kind = CommandKind::kAbort;
  std::string target;
  bool carry = false;
  std::optional<Eigen::Vector3d> p_CT_expected;   // m
  std::optional<geometry::PlanePose> drive_pose;  // X_WR, where to stand: DRIVE's; absent: where it stands
};

struct ServoReport {
  std::int64_t goal_id = 0;  // of ours; 0 when it answers someone else's or none
  ServoState state = ServoState::kHold;
  bool settled = false;
  std::string reason;
  bool follows_another = false;  // someone else's goal, which is repeated
};

struct MarkReport {
  std::string name;
  std::optional<Sight> sight = Sight::kUnseen;    // nothing when TARGET_POSE has no such mark
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();  // m, valid when located
};

// "the mark of NAME is seen by neither camera".
std::string describe_sight(const MarkReport& mark);

struct ArmReport {
  std::int64_t session = 0;
  robot::JointVector q = robot::JointVector::Zero();
  double gripper_opening = 0.0;  // m
};

struct BaseReport {
  std::int64_t utime = 0;    // of BASE_STATUS
  std::int64_t goal_id = 0;  // of ours; 0 when it answers someone else's or none
  BaseState state = BaseState::kHold;
  std::string reason;
  bool follows_another = false;  // someone else's goal, which is repeated
};

struct StopReport {
  bool known = false;       // every stop device has spoken within the last second
  bool latched = false;     // one at least
  std::string reason;       // which, and by whom
  bool meanwhile = false;   // one at least was latched at some time since the last step
  std::string silent = {};  // the devices that are not known, for people
};

// What is to be done when a device is latched, which, and by whom.
std::string describe_latched(const StopReport& stop);

// Everything at one SERVO_STATUS.
struct Input {
  std::int64_t utime = 0;  // the frame's
  std::int64_t now = 0;    // us, the arm's newest time: what commands' age is judged by
  ServoReport servo;
  std::int64_t pose_utime = 0;  // of the newest TARGET_POSE; 0: none yet
  std::vector<MarkReport> marks;
  std::optional<ArmReport> arm;
  std::optional<BaseReport> base;  // the newest from before the frame
  StopReport stop;
  std::vector<Command> commands;  // that came since the last step, repeats included
};

enum class GoalKind { kHold, kPosture, kServo };

struct Goal {
  std::int64_t id = 0;  // grows with every new goal; 0: none yet
  GoalKind kind = GoalKind::kHold;
  std::string target;
  Eigen::Vector3d p_TG = Eigen::Vector3d::Zero();  // m
  double tolerance = 0.0;                          // m
  double speed = 0.0;                              // m/s; 0: visual-servo's own
  robot::JointVector q = robot::JointVector::Zero();
  double opening = 0.0;  // m
  double force = 0.0;    // N
};

// What the base shall do.
struct DriveGoal {
  std::int64_t id = 0;      // grows with every new goal; 0: none yet
  bool drive = false;       // else stand still
  bool from_robot = false;  // `pose` is X_RG, from where the robot stands; else X_WG
  geometry::PlanePose pose;
  double clearance = 0.0;  // m
  double speed = 0.0;      // m/s, at most
};

struct Output {
  Phase phase = Phase::kIdle;
  int attempt = 0;
  Result result = Result::kNone;
  std::string target;
  std::string reason;
  std::int64_t command_session = 0;
  std::int64_t command_id = 0;
  std::optional<Goal> goal;             // to send now
  std::optional<DriveGoal> drive_goal;  // to send now
  std::vector<std::string> notices;     // for the log
};

}  // namespace markservo::task_manager
