#include "services/visual-servo/servo_messages.hpp"

#include <cstdint>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TargetPose.hpp>
#include <stdexcept>
#include <string>

#include "common/messages/message_traits.hpp"
#include "common/messages/state_codes.hpp"
#include "common/states/mark_status.hpp"

namespace markservo::visual_servo {
namespace {

Eigen::Vector3d vector_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Matrix3d matrix_of(const Covariance3& c) {
  Eigen::Matrix3d matrix;
  matrix << c.xx, c.xy, c.xz, c.xy, c.yy, c.yz, c.xz, c.yz, c.zz;
  return matrix;
}

GoalKind kind_of(std::int8_t kind) {
  switch (kind) {
    case ServoGoal::HOLD:
      return GoalKind::kHold;
    case ServoGoal::POSTURE:
      return GoalKind::kPosture;
    case ServoGoal::SERVO:
      return GoalKind::kServo;
    default:
      return GoalKind::kUnknown;
  }
}

}  // namespace

JointSample joint_sample(const JointState& message) {
  if (message.num_joints != robot::kNumJoints) {
    throw std::invalid_argument("JOINT_STATE has " + std::to_string(message.num_joints) +
                                " joints; allowed: " + std::to_string(robot::kNumJoints));
  }
  JointSample sample;
  sample.utime = message.utime;
  sample.session = message.session;
  sample.position << message.position[0], message.position[1], message.position[2];
  sample.gripper_opening = message.gripper_opening;
  sample.contact = message.contact_known != 0 && message.contact != 0;
  return sample;
}

Goal goal_of(const ServoGoal& message) {
  Goal goal;
  goal.utime = message.utime;
  goal.session = message.session;
  goal.id = message.goal_id;
  goal.kind = kind_of(message.kind);
  goal.target = message.target;
  goal.p_TG_C = vector_of(message.p_TG_C);
  goal.tolerance = message.tolerance;
  goal.speed = message.speed;
  goal.position = message.position;
  goal.gripper_opening = message.gripper_opening;
  goal.gripper_force = message.gripper_force;
  return goal;
}

PoseSample pose_sample(const TargetPose& message) {
  PoseSample pose;
  pose.utime = message.frame_utime;
  pose.frame_session = message.frame_session;
  for (const LocatedMark& mark : message.marks) {
    MarkSample sample;
    sample.name = mark.name;
    sample.located = mark.status == LocatedMark::LOCATED;
    if (!sample.located) sample.problem = name_of(messages::state_of<MarkStatus>(mark.status));
    sample.p_C = vector_of(mark.p_C);
    sample.covariance = matrix_of(mark.covariance);
    pose.marks.push_back(sample);
  }
  return pose;
}

JointCommand command_message(const Command& command, const TargetPose& pose) {
  JointCommand message{};
  messages::answer_frame(message, pose);
  message.joint_session = command.joint_session;
  message.num_joints = robot::kNumJoints;
  message.position.assign(command.position.data(), command.position.data() + robot::kNumJoints);
  message.speed_limit.assign(command.speed_limit.data(), command.speed_limit.data() + robot::kNumJoints);
  message.gripper_opening = command.gripper_opening;
  message.gripper_force = command.gripper_force;
  return message;
}

ServoStatus status_message(const Status& status, const TargetPose& pose) {
  ServoStatus message{};
  messages::answer_frame(message, pose);
  message.goal_session = status.goal_session;
  message.goal_id = status.goal_id;
  message.state = messages::code_of(status.state);
  message.settled = status.settled ? 1 : 0;
  message.error_C.x = status.error.x();
  message.error_C.y = status.error.y();
  message.error_C.z = status.error.z();
  message.covariance.xx = status.covariance(0, 0);
  message.covariance.xy = status.covariance(0, 1);
  message.covariance.xz = status.covariance(0, 2);
  message.covariance.yy = status.covariance(1, 1);
  message.covariance.yz = status.covariance(1, 2);
  message.covariance.zz = status.covariance(2, 2);
  message.reason = status.reason;
  return message;
}

}  // namespace markservo::visual_servo
