#include "services/simulator/arm/arm_mjcf.hpp"

#include <cstddef>

#include "common/geometry/degrees.hpp"
#include "common/robot/arm_kinematics.hpp"
#include "services/simulator/arm/gripper_mjcf.hpp"
#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/marks/mark_mjcf.hpp"
#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/model/robot_colours.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;
using robot::ArmDescription;

// m along the forearm, where palm and fingers meet.
double palm_front(const ArmDescription& arm) {
  return arm.forearm + arm.gripper.finger_beyond_grip_point - arm.gripper.finger_length;
}

// The hand's mark in link 2's axes, its plate behind it and a stalk from the palm up to the plate.
std::string hand_mark(const robot::MarkDescription& mark, const ArmDescription& arm) {
  Eigen::Isometry3d X_LM = Eigen::Isometry3d::Identity();
  X_LM.translation() = Vector3d(0.0, arm.forearm, 0.0) + arm.p_GM;
  X_LM.rotate(Eigen::AngleAxisd(-arm.hand_mark_tilt, Vector3d::UnitX()));
  std::string out = print_geom(mark, X_LM);
  constexpr double kPlateThickness = 0.002;  // m
  constexpr double kPlateBorder = 0.0025;    // m
  const Eigen::Isometry3d X_LP = X_LM * Eigen::Translation3d(0.0, kPrintThickness + 0.5 * kPlateThickness, 0.0);
  out += "<geom name=\"hand_mark_plate\" " + placed(X_LP) + " " +
         box({mark.size + 2 * kPlateBorder, kPlateThickness, mark.size + 2 * kPlateBorder}) + " mass=\"0.005\" " +
         coloured(kDark) + " material=\"matt\" " + kArmContact + "/>\n";
  const Vector3d stalk_foot(0.0, palm_front(arm) - 0.004, 0.0);
  const Vector3d stalk_head = X_LP * Vector3d(0.0, 0.005, -0.004);
  out += "<geom name=\"hand_mark_stalk\" type=\"capsule\" size=\"0.0025\" fromto=\"" + mjcf(stalk_foot) + " " +
         mjcf(stalk_head) + "\" mass=\"0.005\" " + coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  return out;
}

// Joint `i` of its body, turning about `axis`.
std::string joint(std::size_t i, const char* axis) {
  constexpr double kArmature = 0.15;  // kg m2, of motor and gears
  return std::string("<joint ") + named(kArmJoints[i]) + " axis=\"" + axis + "\" armature=\"" + mjcf(kArmature) +
         "\" damping=\"" + mjcf(kJointDamping) + "\"/>\n";
}

std::string forearm_body(const robot::RobotDescription& robot, const ArmDescription& arm,
                         const GripperSettings& gripper) {
  constexpr double kHalfWidth = 0.012;   // m, of the forearm's beam
  constexpr double kPalmLength = 0.025;  // m
  const double beam_end = palm_front(arm) - kPalmLength;
  std::string out = "<body name=\"forearm\" " + at({0.0, arm.upper_arm, 0.0}) + ">" + joint(2, "1 0 0");
  out += "<geom name=\"forearm\" " + at({0.0, 0.5 * beam_end, 0.0}) + " " + box({2 * kHalfWidth, beam_end, 0.020}) +
         " mass=\"0.12\" " + coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  out += "<geom name=\"palm\" " + at({0.0, palm_front(arm) - 0.5 * kPalmLength, 0.0}) + " " +
         box({0.060, kPalmLength, 0.022}) + " mass=\"0.08\" " + coloured(kDark) + " material=\"matt\" " + kArmContact +
         "/>\n";
  for (const auto& mark : robot.marks) {
    if (mark.role == robot::MarkRole::kManipulator) out += hand_mark(mark, arm);
  }
  out += gripper_bodies(arm, gripper);
  return out + "</body>\n";
}

}  // namespace

robot::ArmDescription true_arm(const robot::ArmDescription& described, const CalibrationSettings& calibration,
                               const ArmSettings& settings) {
  ArmDescription arm = described;
  arm.p_CA += Vector3d(calibration.arm_x, calibration.arm_y, calibration.arm_z);
  arm.yaw_CA += calibration.arm_yaw_deg * geometry::kRadiansPerDegree;
  arm.column *= settings.link_scale;
  arm.upper_arm *= settings.link_scale;
  arm.forearm *= settings.link_scale;
  return arm;
}

std::string arm_bodies(const robot::RobotDescription& robot, const ArmDescription& arm,
                       const GripperSettings& gripper) {
  std::string out = "<body " + named(kArmColumn) + " " + placed(robot::arm_base_pose(arm)) +
                    ">\n<geom name=\"column\" type=\"cylinder\" size=\"0.022 " + mjcf(0.5 * (arm.column - 0.025)) +
                    "\" " + at({0.0, 0.0, 0.5 * (arm.column - 0.025)}) + " " + coloured(kDark) + " material=\"matt\" " +
                    kArmContact + "/>\n";
  out += "<body name=\"turret\" " + at({0.0, 0.0, arm.column}) + ">" + joint(0, "0 0 1");
  out += std::string("<geom name=\"turret\" type=\"cylinder\" size=\"0.024 0.012\" pos=\"0 0 -0.012\" mass=\"0.1\" ") +
         coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  out += "<body name=\"upper_arm\">" + joint(1, "1 0 0");
  out += "<geom name=\"upper_arm\" " + at({0.0, 0.5 * arm.upper_arm, 0.0}) + " " +
         box({0.026, arm.upper_arm + 0.02, 0.024}) + " mass=\"0.2\" " + coloured(kMetal) + " material=\"matt\" " +
         kArmContact + "/>\n";
  out += forearm_body(robot, arm, gripper);
  return out + "</body></body></body>\n";
}

}  // namespace markservo::simulator
