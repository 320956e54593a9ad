#pragma once

// What the servo core is told and what it answers: plain structs behind the messages of lcmtypes. SI units, rad, camera
// frame C (x right, y forward, z up) unless a name says otherwise; utime in us of measurement.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "common/states/servo_state.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::visual_servo {

using robot::JointVector;

// One JOINT_STATE.
struct JointSample {
  std::int64_t utime = 0;    // us
  std::int64_t session = 0;  // of the writer
  JointVector position = JointVector::Zero();
  double gripper_opening = 0.0;  // m
  bool contact = false;          // the gripper is known to hold something
};

// One mark of a TARGET_POSE.
struct MarkSample {
  std::string name;
  bool located = false;
  std::string problem;                                   // why it is not located, for people
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();         // m, valid when located
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2
};

// One TARGET_POSE.
struct PoseSample {
  std::int64_t utime = 0;  // us, of the exposure
  std::int64_t frame_session = 0;
  std::vector<MarkSample> marks;
  std::string doubt = {};  // why it must not be acted on: another writer's; empty when nothing speaks against it
};

enum class GoalKind { kHold, kPosture, kServo, kUnknown };

// One SERVO_GOAL.
struct Goal {
  std::int64_t utime = 0;  // us
  std::int64_t session = 0;
  std::int64_t id = 0;
  GoalKind kind = GoalKind::kHold;
  std::string target;                                // servo: name of the target's mark
  Eigen::Vector3d p_TG_C = Eigen::Vector3d::Zero();  // m, servo: wanted grip point from the target mark
  double tolerance = 0.0;                            // m, servo; 0: the parameters' own
  double speed = 0.0;                                // m/s of the grip point; 0: the parameters' own
  std::vector<double> position;                      // rad, posture
  double gripper_opening = 0.0;                      // m
  double gripper_force = 0.0;                        // N
};

// One JOINT_COMMAND.
struct Command {
  JointVector position = JointVector::Zero();
  JointVector speed_limit = JointVector::Zero();  // rad/s, above 0
  std::int64_t joint_session = 0;                 // of the joint states that it was made from
  double gripper_opening = 0.0;                   // m
  double gripper_force = 0.0;                     // N
};

// One SERVO_STATUS.
struct Status {
  ServoState state = ServoState::kHold;
  bool settled = false;                                  // the arm rests where it was told to be
  Eigen::Vector3d error = Eigen::Vector3d::Zero();       // m, grip point minus goal
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2, of error
  std::string reason;                                    // why it cannot go on
  std::int64_t goal_session = 0;
  std::int64_t goal_id = 0;
};

// What answers one TARGET_POSE. There is no command before the first JOINT_STATE: nothing is known that could be held.
struct Output {
  std::optional<Command> command;
  Status status;
};

}  // namespace markservo::visual_servo
