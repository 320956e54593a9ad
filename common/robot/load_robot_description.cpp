#include <array>
#include <cmath>
#include <fstream>
#include <set>

#include "common/geometry/camera_bounds.hpp"
#include "common/geometry/plane_pose.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/load_base.hpp"
#include "common/robot/robot_description.hpp"
#include "common/robot/yaml_section.hpp"

namespace markservo::robot {
namespace {

constexpr std::array<const char*, kNumJoints> kJointNames = {"yaw", "shoulder", "elbow"};

using geometry::radians;

// A mark smaller or larger than this is a slip of units.
const Allowed kMarkSize = Allowed::between(0.001, 2.0);

Allowed within(const geometry::Bounds& bounds) {
  return Allowed::between(bounds.min, bounds.max);
}

CameraDescription load_cameras(YamlSection section) {
  CameraDescription cameras;
  cameras.width = section.integer("width_px", 1, 16384);
  cameras.height = section.integer("height_px", 1, 16384);
  cameras.stereo.fx = section.number("fx_px", within(geometry::focal_length_bounds(cameras.width)));
  cameras.stereo.fy = section.number("fy_px", within(geometry::focal_length_bounds(cameras.width)));
  cameras.stereo.cx_left = section.number("cx_left_px", within(geometry::principal_point_bounds(cameras.width)));
  cameras.stereo.cx_right = section.number("cx_right_px", within(geometry::principal_point_bounds(cameras.width)));
  cameras.stereo.cy = section.number("cy_px", within(geometry::principal_point_bounds(cameras.height)));
  cameras.stereo.baseline = section.number("baseline", within(geometry::kBaselineBounds));
  cameras.p_RC = section.numbers("p_RC", 3, Allowed::any());
  section.require_all_used();
  return cameras;
}

JointDescription load_joint(YamlSection section) {
  JointDescription joint;
  joint.name = section.text("name");
  const double min_deg = section.number("min_deg", Allowed::between(-360.0, 360.0));
  const double max_deg = section.number("max_deg", Allowed::between(min_deg, 360.0));
  joint.min = radians(min_deg);
  joint.max = radians(max_deg);
  joint.speed = radians(section.number("speed_deg_s", Allowed::positive()));
  section.require_all_used();
  return joint;
}

GripperDescription load_gripper(YamlSection section) {
  GripperDescription gripper;
  gripper.opening_max = section.number("opening_max", Allowed::positive());
  gripper.finger_length = section.number("finger_length", Allowed::positive());
  gripper.finger_thickness = section.number("finger_thickness", Allowed::positive());
  gripper.finger_beyond_grip_point =
      section.number("finger_beyond_grip_point", Allowed::between(0.0, gripper.finger_length));
  gripper.force_max = section.number("force_max", Allowed::positive());
  section.require_all_used();
  return gripper;
}

ArmDescription load_arm(YamlSection section) {
  ArmDescription arm;
  arm.p_CA = section.numbers("p_CA", 3, Allowed::any());
  arm.yaw_CA = radians(section.number("yaw_CA_deg", Allowed::between(-180.0, 180.0)));
  const Eigen::Vector3d links = section.numbers("links", 3, Allowed::positive());
  arm.column = links[0];
  arm.upper_arm = links[1];
  arm.forearm = links[2];
  auto joints = section.list("joints");
  if (joints.size() != kNumJoints) {
    section.fail("joints", "a list of " + std::to_string(joints.size()), "3 joints: yaw, shoulder, elbow");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    arm.joints[i] = load_joint(joints[i]);
    if (arm.joints[i].name != kJointNames[i]) {
      joints[i].fail("name", "'" + arm.joints[i].name + "'", std::string(kJointNames[i]) + ", the joint in this place");
    }
  }
  const Eigen::Vector3d home_deg = section.numbers("home_deg", kNumJoints, Allowed::between(-360.0, 360.0));
  for (int i = 0; i < kNumJoints; ++i) {
    const JointDescription& joint = arm.joints[static_cast<std::size_t>(i)];
    arm.home[i] = radians(home_deg[i]);
    if (arm.home[i] < joint.min || arm.home[i] > joint.max) {
      section.fail("home_deg[" + std::to_string(i) + "]", std::to_string(home_deg[i]),
                   "within the limits of joint " + joint.name);
    }
  }
  YamlSection hand_mark = section.section("hand_mark");
  arm.p_GM = hand_mark.numbers("p_GM", 3, Allowed::any());
  arm.hand_mark_tilt = radians(hand_mark.number("tilt_deg", Allowed::between(-90.0, 90.0)));
  hand_mark.require_all_used();
  arm.gripper = load_gripper(section.section("gripper"));
  section.require_all_used();
  return arm;
}

ColourInterval load_colour(YamlSection section) {
  const Eigen::Vector2d hue = section.numbers("hue_deg", 2, Allowed::between(0.0, 360.0));
  const Eigen::Vector2d saturation = section.numbers("saturation", 2, Allowed::between(0.0, 1.0));
  const Eigen::Vector2d value = section.numbers("value", 2, Allowed::between(0.0, 1.0));
  if (saturation[0] > saturation[1]) section.fail("saturation", "falling", "[least, greatest]");
  if (value[0] > value[1]) section.fail("value", "falling", "[least, greatest]");
  section.require_all_used();
  return {hue[0], hue[1], saturation[0], saturation[1], value[0], value[1]};
}

GripDescription load_grip(YamlSection section) {
  GripDescription grip;
  grip.p_TG = section.numbers("p_TG", 3, Allowed::between(-1.0, 1.0));
  grip.object_width = section.number("object_width", Allowed::positive());
  grip.spacing = section.number("spacing", Allowed::positive());
  section.require_all_used();
  return grip;
}

MarkSurface load_surface(YamlSection& section) {
  const std::string word = section.one_of("surface", {"plane", "free", "ball"});
  if (word == "ball") return MarkSurface::kBall;
  return word == "free" ? MarkSurface::kFree : MarkSurface::kPlane;
}

MarkOutline load_outline(YamlSection& section, MarkSurface surface) {
  const std::string word = section.one_of("outline", {"square", "disc", "other"});
  if (surface != MarkSurface::kPlane) section.fail("outline", word, "no outline but where surface is plane");
  if (word == "disc") return MarkOutline::kDisc;
  return word == "other" ? MarkOutline::kOther : MarkOutline::kSquare;
}

MarkDescription load_mark(YamlSection section) {
  MarkDescription mark;
  mark.name = section.text("name");
  mark.role =
      section.one_of("role", {"target", "manipulator"}) == "target" ? MarkRole::kTarget : MarkRole::kManipulator;
  mark.size = section.number("size", kMarkSize);
  mark.surface = load_surface(section);
  if (section.has("outline")) mark.outline = load_outline(section, mark.surface);
  mark.colour = load_colour(section.section("colour"));
  if (section.has("grip")) mark.grip = load_grip(section.section("grip"));
  section.require_all_used();
  return mark;
}

std::vector<MarkDescription> load_marks(YamlSection& root) {
  constexpr std::size_t kMaxNameLength = 32;  // likewise
  std::vector<MarkDescription> marks;
  std::set<std::string> names;
  auto sections = root.list("marks");
  if (sections.empty() || sections.size() > kMaxMarks) {
    root.fail("marks", "a list of " + std::to_string(sections.size()), "1 to " + std::to_string(kMaxMarks) + " marks");
  }
  for (auto& section : sections) {
    marks.push_back(load_mark(section));
    const std::string& name = marks.back().name;
    if (name.size() > kMaxNameLength) {
      section.fail("name", "'" + name + "'", "at most " + std::to_string(kMaxNameLength) + " characters");
    }
    if (!names.insert(name).second) section.fail("name", "'" + name + "' twice", "a name of its own for each mark");
  }
  return marks;
}

}  // namespace

const MarkDescription* RobotDescription::find_mark(const std::string& name) const {
  for (const auto& mark : marks) {
    if (mark.name == name) return &mark;
  }
  return nullptr;
}

RobotDescription load_robot_description(const std::string& path) {
  // The usual reason is another working directory than the project's.
  if (!std::ifstream(path)) {
    throw ConfigurationError(path + ": cannot be opened; allowed: a readable robot description, --robot-file FILE");
  }
  YamlSection root = YamlSection::load(path);
  RobotDescription robot;
  robot.cameras = load_cameras(root.section("cameras"));
  if (root.has("arm")) robot.arm = load_arm(root.section("arm"));
  robot.marks = load_marks(root);

  if (robot.arm) {
    YamlSection workspace = root.section("workspace");
    robot.workspace.joint_margin = radians(workspace.number("joint_margin_deg", Allowed::between(0.0, 45.0)));
    robot.workspace.view_margin_px = workspace.number("view_margin_px", Allowed::between(0.0, 1000.0));
    robot.workspace.finger_clearance = workspace.number("finger_clearance", Allowed::between(0.0, 1.0));
    workspace.require_all_used();

    YamlSection law = root.section("paper_law");
    PaperLawDescription paper_law;
    paper_law.gains = law.numbers("gains_rad_s_per_m", kNumJoints, Allowed::any());
    paper_law.offset_TM = law.numbers("offset_TM", 3, Allowed::between(-1.0, 1.0));
    robot.paper_law = paper_law;
    law.require_all_used();
    robot.stop_devices = root.texts("stop_devices");
  }
  load_base_sections(root, robot);
  root.require_all_used();
  return robot;
}

}  // namespace markservo::robot
