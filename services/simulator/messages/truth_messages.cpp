#include "services/simulator/messages/truth_messages.hpp"

#include <Eigen/Geometry>
#include <markservo/SimTruth.hpp>
#include <utility>

#include "services/simulator/messages/joint_values.hpp"

namespace markservo::simulator {
namespace {

Vector3 vector3(const Eigen::Vector3d& v) {
  Vector3 message{};
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

SimBody body_message(const BodyTruth& body) {
  SimBody message{};
  message.name = body.name;
  message.p_CB = vector3(body.X_CB.translation());
  const Eigen::Quaterniond q(body.X_CB.linear());
  message.q_CB_w = q.w();
  message.q_CB_x = q.x();
  message.q_CB_y = q.y();
  message.q_CB_z = q.z();
  message.height_gain = body.height_gain;
  message.touches_left_finger = body.touches_left_finger ? 1 : 0;
  message.touches_right_finger = body.touches_right_finger ? 1 : 0;
  message.touches_other = body.touches_other ? 1 : 0;
  return message;
}

}  // namespace

SimTruth truth_message(const WorldTruth& truth) {
  SimTruth message{};
  message.num_joints = robot::kNumJoints;
  message.shaft = joint_values(truth.shaft);
  message.p_CG = vector3(truth.p_CG);
  message.gripper_opening = truth.gripper_opening;
  message.arm_touched = truth.arm_touched ? 1 : 0;
  message.touched = truth.touched;
  for (const BodyTruth& body : truth.bodies) message.bodies.push_back(body_message(body));
  message.num_bodies = static_cast<std::int32_t>(message.bodies.size());
  for (const MarkTruth& mark : truth.marks) {
    SimMark mark_message{};
    mark_message.name = mark.name;
    mark_message.p_C = vector3(mark.p_CM);
    mark_message.normal_C = vector3(mark.normal_C);
    message.marks.push_back(std::move(mark_message));
  }
  message.num_marks = static_cast<std::int32_t>(message.marks.size());
  return message;
}

}  // namespace markservo::simulator
