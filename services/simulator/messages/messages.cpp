#include "services/simulator/messages/messages.hpp"

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

namespace markservo::simulator {
namespace {

Vector3 vector3(const Eigen::Vector3d& v) {
  Vector3 message{};
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

std::vector<double> joint_values(const robot::JointVector& q) {
  return {q.data(), q.data() + q.size()};
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

std::vector<std::uint8_t> encoded(const cv::Mat& image, int jpeg_quality) {
  if (jpeg_quality == 0) return {image.datastart, image.dataend};
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
  return bytes;
}

}  // namespace

ArmCommand arm_command(const JointCommand& message) {
  if (message.num_joints != robot::kNumJoints) {
    throw std::invalid_argument("num_joints is " + std::to_string(message.num_joints) +
                                "; allowed: " + std::to_string(robot::kNumJoints));
  }
  ArmCommand command;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    command.position[i] = message.position[static_cast<std::size_t>(i)];
    command.speed_limit[i] = message.speed_limit[static_cast<std::size_t>(i)];
  }
  command.gripper_opening = message.gripper_opening;
  command.gripper_force = message.gripper_force;
  return command;
}

JointState joint_state_message(const ArmReading& arm) {
  JointState message{};
  message.num_joints = robot::kNumJoints;
  message.position = joint_values(arm.position);
  message.speed = joint_values(arm.speed);
  message.measured = 0;
  message.moving = arm.moving ? 1 : 0;
  message.gripper_opening = arm.gripper_opening;
  message.contact_known = 0;
  message.contact = 0;
  return message;
}

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

StereoFrame frame_message(const robot::CameraDescription& cameras, const CalibrationSettings& settings,
                          const ImagePair& images, int jpeg_quality) {
  StereoFrame message{};
  message.calibration.fx = cameras.stereo.fx * settings.f_scale;
  message.calibration.fy = cameras.stereo.fy * settings.f_scale;
  message.calibration.cx_left = cameras.stereo.cx_left;
  message.calibration.cx_right = cameras.stereo.cx_right;
  message.calibration.cy = cameras.stereo.cy;
  message.calibration.baseline = cameras.stereo.baseline * settings.b_scale;
  message.width = images.left.cols;
  message.height = images.left.rows;
  message.encoding = jpeg_quality == 0 ? StereoFrame::ENCODING_BGR8 : StereoFrame::ENCODING_JPEG;
  message.left = encoded(images.left, jpeg_quality);
  message.right = encoded(images.right, jpeg_quality);
  message.left_size = static_cast<std::int32_t>(message.left.size());
  message.right_size = static_cast<std::int32_t>(message.right.size());
  return message;
}

}  // namespace markservo::simulator
