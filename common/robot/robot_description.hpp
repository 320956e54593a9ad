#pragma once

// The robot as config/robot.yaml describes it: what every service may know about the hardware. SI units, radians.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
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
enum class MarkSurface {
  kPlane,  // one flat piece
  kFree,   // all that has the colour, of any form
  kBall,
};
enum class MarkOutline { kSquare, kDisc, kOther };  // of a plane

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
  double size = 0.0;  // m, edge of the square; diameter of a disc or ball; about the width of any other
  MarkSurface surface = MarkSurface::kPlane;
  MarkOutline outline = MarkOutline::kSquare;
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

// Differential drive. R's origin is in the middle between the wheels.
struct BaseDescription {
  double wheel_radius = 0.0;  // m
  double track = 0.0;         // m, between the wheels' middles
  int ticks_per_turn = 0;
  int counter_bits = 32;      // the tick counters wrap around at 2^counter_bits
  double scale_sigma = 0.0;   // standard deviation of the true distance over the ticks' minus 1
  double drift = 0.0;         // rad per sqrt(m), random walk of the true heading against the ticks'
  double pivot_wander = 0.0;  // m per sqrt(rad), each axis: random walk of the place while the base turns
  double front = 0.0;         // m, the outline in R: -rear <= x <= front, |y| <= half_width
  double rear = 0.0;
  double half_width = 0.0;
  double speed_max = 0.0;              // m/s
  double turn_rate_max = 0.0;          // rad/s
  double acceleration_max = 0.0;       // m/s^2
  double turn_acceleration_max = 0.0;  // rad/s^2

  // m that a wheel goes per tick
  double metres_per_tick() const;
};

// A ring of sonars around R's origin, evenly spaced, looking outward; number 0 ahead, then to the left.
struct SonarRingDescription {
  int number = 0;
  double ring_radius = 0.0;  // m
  double height = 0.0;       // m above the floor
  double beam_width = 0.0;   // rad, full cone
  double min_range = 0.0;    // m
  double max_range = 0.0;    // m

  // X_RS of sonar `i`, whose x is the beam's middle; its heading counts up from 0.
  geometry::PlanePose pose(int i) const;
};

struct RfidDescription {
  Eigen::Vector2d p_RF = Eigen::Vector2d::Zero();  // m, the antenna's middle in R
  double reading_radius = 0.0;                     // m, where half the reads fail
  double edge_softness = 0.0;                      // m, scale of the logistic edge
  double read_probability = 0.0;                   // (0, 1), of a tag well inside, each round
  double round_time = 0.0;                         // s
  double delay = 0.0;                              // s, from the middle of a round to its arrival at the host
  double delay_sigma = 0.0;                        // s, its uncertainty
};

struct FloorTag {
  std::string uid;                                // hexadecimal, upper case
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // m
};

struct TagField {
  std::string name;
  std::vector<FloorTag> tags;  // one at least; no uid twice
};

struct FloorTagsDescription {
  std::string in_use;         // a field's name
  double survey_sigma = 0.0;  // m, each axis of every position
  std::vector<TagField> fields;

  // The field of that name, or the one in use if `name` is empty. Throws ConfigurationError if there is none.
  const TagField& field(const std::string& name) const;
};

struct RobotDescription {
  CameraDescription cameras;
  std::optional<ArmDescription> arm;  // absent: two cameras and marks only
  std::vector<MarkDescription> marks;
  WorkspaceParameters workspace;
  std::optional<PaperLawDescription> paper_law;
  std::vector<std::string> stop_devices;
  std::optional<BaseDescription> base;  // absent: the robot stands
  std::optional<SonarRingDescription> sonars;
  std::optional<RfidDescription> rfid;
  std::optional<FloorTagsDescription> floor_tags;

  // The mark of that name, or null.
  const MarkDescription* find_mark(const std::string& name) const;
};

// Reads and checks a robot.yaml. Throws ConfigurationError: one line with file, key, value and what is allowed.
RobotDescription load_robot_description(const std::string& path);

}  // namespace markservo::robot
