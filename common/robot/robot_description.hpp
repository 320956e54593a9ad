#pragma once

// The robot as config/robot.yaml describes it: what every service may know about the hardware. SI units, radians.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::robot {

inline constexpr int kNumJoints = 3;  // yaw, shoulder, elbow
using JointVector = Eigen::Vector3d;  // rad, in that order

struct CameraDescription {
  int width = 0;   // px, of each image
  int height = 0;  // px
  geometry::StereoCamera stereo;
  Eigen::Vector3d p_RC = Eigen::Vector3d::Zero();  // m, left lens in the robot frame
};

struct JointDescription {
  std::string name;
  double min = 0.0;    // rad
  double max = 0.0;    // rad
  double speed = 0.0;  // rad/s, the servo's own limit
};

struct GripperDescription {
  double opening_max = 0.0;               // m, between the fingers
  double finger_length = 0.0;             // m
  double finger_thickness = 0.0;          // m
  double finger_beyond_grip_point = 0.0;  // m, from G to the fingertip
  double force_max = 0.0;                 // N, each finger
};

struct ArmDescription {
  Eigen::Vector3d p_CA = Eigen::Vector3d::Zero();  // m, foot of the column in C
  double yaw_CA = 0.0;                             // rad, A turned about z against C
  double column = 0.0;                             // m, link 0
  double upper_arm = 0.0;                          // m, link 1
  double forearm = 0.0;                            // m, link 2 up to the grip point G
  std::array<JointDescription, kNumJoints> joints;
  JointVector home = JointVector::Zero();          // rad
  Eigen::Vector3d p_GM = Eigen::Vector3d::Zero();  // m, hand mark from G: x right, y along the forearm, z across and up
  double hand_mark_tilt = 0.0;  // rad, hand mark turned down about x against the forearm's cross plane
  GripperDescription gripper;
};

// A colour interval in hue, saturation and value. Hue wraps: from 345 to 15 degrees is red.
struct ColourInterval {
  double hue_min_deg = 0.0;     // [0, 360)
  double hue_max_deg = 0.0;     // [0, 360)
  double saturation_min = 0.0;  // [0, 1]
  double saturation_max = 1.0;
  double value_min = 0.0;  // [0, 1]
  double value_max = 1.0;
};

enum class MarkRole { kTarget, kManipulator };
enum class MarkSurface { kPlane, kFree };

// How an object is gripped, told from its mark.
struct GripDescription {
  Eigen::Vector3d p_TG = Eigen::Vector3d::Zero();  // m, grip point from the mark's centre, axes of C
  double object_width = 0.0;                       // m, what the fingers enclose
  double spacing = 0.0;                            // m, from this object's middle to its neighbours'
};

inline constexpr std::size_t kMaxMarks = 8;  // a byte of mask bits; TARGET_POSE fits one packet

struct MarkDescription {
  std::string name;
  MarkRole role = MarkRole::kTarget;
  double size = 0.0;  // m, edge of the square
  MarkSurface surface = MarkSurface::kPlane;
  ColourInterval colour;
  std::optional<GripDescription> grip;  // targets that can be taken
};

struct WorkspaceParameters {
  double joint_margin = 0.0;      // rad
  double view_margin_px = 0.0;    // px
  double finger_clearance = 0.0;  // m
};

// Constants of the paper's law (eq. 6).
struct PaperLawDescription {
  JointVector gains = JointVector::Zero();              // rad/s per m, signed
  Eigen::Vector3d offset_TM = Eigen::Vector3d::Zero();  // m, wanted hand mark from the target mark, axes of C
};

struct RobotDescription {
  CameraDescription cameras;
  std::optional<ArmDescription> arm;  // absent: two cameras and marks only
  std::vector<MarkDescription> marks;
  WorkspaceParameters workspace;
  std::optional<PaperLawDescription> paper_law;
  std::vector<std::string> stop_devices;

  // The mark of that name, or null.
  const MarkDescription* find_mark(const std::string& name) const;
};

// Reads and checks a robot.yaml. Throws ConfigurationError: one line with file, key, value and what is allowed.
RobotDescription load_robot_description(const std::string& path);

}  // namespace markservo::robot
