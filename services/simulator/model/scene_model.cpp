#include "services/simulator/model/scene_model.hpp"

#include <cmath>

#include "common/robot/arm_kinematics.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/random.hpp"
#include "services/simulator/scene/room_model.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;
using robot::ArmDescription;

constexpr double kRadiansPerDegree = 0.017453292519943295;
constexpr double kPi = 3.141592653589793;

// The print's box is drawn with its local z towards the cameras: MuJoCo draws 2D textures true on that side only.
const Eigen::Matrix3d kPrintTurn = Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()).toRotationMatrix();

const Rgb kMetal(0.62, 0.64, 0.66);
const Rgb kDark(0.16, 0.16, 0.17);
const Rgb kWood(0.47, 0.40, 0.34);
const Rgb kPaper(0.86, 0.84, 0.78);
const Rgb kLetters(0.75, 0.74, 0.70);

// MuJoCo's solver ends when the rest no longer matters beside the mean of all joints' inertia. The base's own, which
// stands for "moved by nothing", must not count: this is the mean over arm and books.
constexpr double kMeanInertia = 0.164;

// The base's inertia in the model, kg and kg m2: no force there is moves it.
constexpr double kBaseInertia = 1e6;

Vector3d marks_middle(const Scene& scene, const Settings& settings) {
  return {settings.books.x, settings.books.y, scene.books.mark_z};
}

void check_cameras(const robot::CameraDescription& cameras) {
  const auto& stereo = cameras.stereo;
  const double middle_u = 0.5 * (cameras.width - 1);
  const double middle_v = 0.5 * (cameras.height - 1);
  if (stereo.fx != stereo.fy) {
    throw ConfigurationError("cameras.fy_px is " + mjcf(stereo.fy) + "; allowed in the simulator: cameras.fx_px, " +
                             mjcf(stereo.fx));
  }
  if (stereo.cx_left != middle_u || stereo.cx_right != middle_u || stereo.cy != middle_v) {
    throw ConfigurationError("cameras.cx_left_px, cx_right_px, cy_px are " + mjcf(stereo.cx_left) + ", " +
                             mjcf(stereo.cx_right) + ", " + mjcf(stereo.cy) +
                             "; allowed in the simulator: the image's middle, " + mjcf(middle_u) + ", " +
                             mjcf(middle_u) + ", " + mjcf(middle_v));
  }
}

std::string header(const robot::CameraDescription& cameras, double ambient) {
  const double fovy_deg = 2.0 * std::atan(0.5 * cameras.height / cameras.stereo.fy) / kRadiansPerDegree;
  const std::string grey = mjcf(Vector3d(ambient, ambient, ambient));
  return "<mujoco model=\"markservo\">\n"
         "<compiler angle=\"radian\" autolimits=\"true\"/>\n"
         "<option timestep=\"" +
         mjcf(kTimeStep) +
         "\" integrator=\"implicit\" cone=\"elliptic\" impratio=\"40\"/>\n"
         "<statistic extent=\"1\" center=\"0 0.3 0\" meansize=\"0.1\" meaninertia=\"" +
         mjcf(kMeanInertia) +
         "\"/>\n"
         "<visual><global offwidth=\"" +
         std::to_string(cameras.width) + "\" offheight=\"" + std::to_string(cameras.height) + "\" fovy=\"" +
         mjcf(fovy_deg) +
         "\"/><quality offsamples=\"4\" shadowsize=\"0\"/>"
         "<map znear=\"0.02\" zfar=\"20\"/><headlight ambient=\"" +
         grey + "\" diffuse=\"0 0 0\" specular=\"0 0 0\"/></visual>\n";
}

std::string cameras_of(const robot::CameraDescription& cameras) {
  const double fovy_deg = 2.0 * std::atan(0.5 * cameras.height / cameras.stereo.fy) / kRadiansPerDegree;
  const auto camera = [&](const char* name, double x) {
    return "<camera " + named(name) + " " + at({x, 0.0, 0.0}) + " xyaxes=\"1 0 0 0 0 1\" fovy=\"" + mjcf(fovy_deg) +
           "\"/>\n";
  };
  return camera(kLeftCamera, 0.0) + camera(kRightCamera, cameras.stereo.baseline);
}

std::string lamps(const LightScene& light, double vary, std::uint64_t seed) {
  constexpr double kBrightnessVariation = 0.12;  // share either way
  constexpr double kDirectionVariation = 0.25;   // of the direction's length, about 15 degrees
  RandomBits bits(seed_for(seed, 0x11, 0));
  std::string out;
  for (const Lamp& lamp : light.lamps) {
    Vector3d direction = lamp.direction.normalized();
    for (int i = 0; i < 3; ++i) direction[i] += vary * kDirectionVariation * bits.symmetric();
    const double brightness = lamp.brightness * (1.0 + vary * kBrightnessVariation * bits.symmetric());
    out += "<light directional=\"true\" castshadow=\"false\" pos=\"0 0 1\" dir=\"" +
           mjcf(Vector3d(direction.normalized())) + "\" ambient=\"0 0 0\" specular=\"0 0 0\" diffuse=\"" +
           mjcf(Vector3d(brightness, brightness, brightness)) + "\"/>\n";
  }
  return out;
}

std::string textured(SceneModel& model, const std::string& name, Texture texture) {
  const std::string edge = std::to_string(texture.edge);
  model.textures[name] = std::move(texture);
  return "<texture " + named(name) + " type=\"2d\" builtin=\"flat\" rgb1=\"1 1 1\" width=\"" + edge + "\" height=\"" +
         edge + "\"/><material " + named(name) + " texture=\"" + name + "\" specular=\"0\" shininess=\"0\"/>\n";
}

std::string assets(SceneModel& model, const robot::RobotDescription& robot, const Scene& scene) {
  constexpr int kPrintEdge_px = 256;
  constexpr int kWallEdge_px = 512;
  std::string out = "<asset>\n<material name=\"matt\" specular=\"0.05\" shininess=\"0.1\"/>\n";
  for (const auto& mark : robot.marks)
    out += textured(model, print_name(mark.name), mark_texture(mark, scene.print, kPrintEdge_px));
  out += textured(model, "wall", surface_texture(scene.room.wall, 0.35, "wall", kWallEdge_px));
  out += textured(model, "floor", surface_texture(scene.room.floor, 0.4, "floor", kWallEdge_px));
  out += textured(model, "wood", surface_texture(kWood, 0.3, "wood", kPrintEdge_px));
  return out + "</asset>\n";
}

// A mark whose printed face has pose X (x right, z up along its edges, -y out of the print).
std::string print_geom(const robot::MarkDescription& mark, const Eigen::Isometry3d& X) {
  Eigen::Isometry3d turned = X * Eigen::Translation3d(0.0, 0.5 * kPrintThickness, 0.0);
  turned.rotate(kPrintTurn);
  return "<geom " + named(print_name(mark.name)) + " " + placed(turned) + " " +
         box({mark.size, mark.size, kPrintThickness}) + " material=\"" + print_name(mark.name) + "\" " + kNoContact +
         "/>\n";
}

std::string book_body(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                      const BookScene& book) {
  const BooksScene& books = scene.books;
  const robot::MarkDescription& mark = *robot.find_mark(book.mark);
  const double spine_y = -0.5 * books.size[1];
  const double mark_z = books.mark_z - scene.shelf.top_z - 0.5 * books.size[2];
  Eigen::Isometry3d X_BM = Eigen::Isometry3d::Identity();
  X_BM.translation() << 0.0, spine_y - kPrintThickness, mark_z;

  std::string out = "<body " + named(book.mark) + " " + placed(book_pose(scene, settings, book)) + "><freejoint/>\n";
  out += "<geom " + named(book.mark) + " " + box(books.size) + " mass=\"" + mjcf(books.mass) + "\" " +
         coloured(book.cover) + " material=\"matt\" " + kBookContact + " condim=\"4\" friction=\"" +
         mjcf(settings.books.friction) + " 0.005 0.0001\" " + kStiff + "/>\n";
  out += print_geom(mark, X_BM);
  // The look of a book: pages at the top, a title on the spine.
  constexpr double kInk = 0.0001;  // m, raised
  const auto look = [&](const Vector3d& centre, const Vector3d& edges, const Rgb& colour) {
    out +=
        "<geom " + at(centre) + " " + box(edges) + " " + coloured(colour) + " material=\"matt\" " + kNoContact + "/>\n";
  };
  look({0.0, 0.003, 0.5 * books.size[2]}, {0.78 * books.size[0], books.size[1] - 0.008, 2 * kInk}, kPaper);
  for (const double z : {-0.034, -0.042, -0.049}) {
    look({0.0, spine_y, mark_z + z}, {0.6 * books.size[0], 2 * kInk, 0.0035}, kLetters);
  }
  look({0.0, spine_y, mark_z + 0.024}, {books.size[0], 2 * kInk, 0.002}, kLetters);
  return out + "</body>\n";
}

std::string finger_body(const ArmDescription& arm, const Settings& settings, const char* name, double side) {
  constexpr double kFingerHeight = 0.016;  // m, across the forearm
  const auto& gripper = arm.gripper;
  const Vector3d centre(side * 0.5 * gripper.finger_thickness,
                        arm.forearm + gripper.finger_beyond_grip_point - 0.5 * gripper.finger_length, 0.0);
  return std::string("<body ") + named(name) + "><joint " + named(name) + " type=\"slide\" axis=\"" + mjcf(side) +
         " 0 0\" range=\"0 " + mjcf(0.5 * gripper.opening_max) + "\" armature=\"0.5\" damping=\"200\"/>\n<geom " +
         named(name) + " " + at(centre) + " " + box({gripper.finger_thickness, gripper.finger_length, kFingerHeight}) +
         " mass=\"0.02\" " + coloured(kDark) + " material=\"matt\" " + kArmContact +
         " priority=\"1\" condim=\"4\" friction=\"" + mjcf(settings.gripper.friction) + " 0.01 0.0001\" " + kStiff +
         "/></body>\n";
}

std::string forearm_body(const robot::RobotDescription& robot, const ArmDescription& arm, const Settings& settings) {
  constexpr double kHalfWidth = 0.012;  // m, of the forearm's beam
  const auto& gripper = arm.gripper;
  const double palm_front = arm.forearm + gripper.finger_beyond_grip_point - gripper.finger_length;
  const double palm_length = 0.025;
  const double beam_end = palm_front - palm_length;
  std::string out = "<body name=\"forearm\" " + at({0.0, arm.upper_arm, 0.0}) +
                    "><joint name=\"elbow\" axis=\"1 0 0\" armature=\"0.15\" damping=\"60\"/>\n";
  out += "<geom name=\"forearm\" " + at({0.0, 0.5 * beam_end, 0.0}) + " " + box({2 * kHalfWidth, beam_end, 0.020}) +
         " mass=\"0.12\" " + coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  out += "<geom name=\"palm\" " + at({0.0, palm_front - 0.5 * palm_length, 0.0}) + " " +
         box({0.060, palm_length, 0.022}) + " mass=\"0.08\" " + coloured(kDark) + " material=\"matt\" " + kArmContact +
         "/>\n";

  for (const auto& mark : robot.marks) {
    if (mark.role != robot::MarkRole::kManipulator) continue;
    // The mark in link 2's axes, then its plate behind it and a stalk from the palm up to the plate.
    Eigen::Isometry3d X_LM = Eigen::Isometry3d::Identity();
    X_LM.translation() = Vector3d(0.0, arm.forearm, 0.0) + arm.p_GM;
    X_LM.rotate(Eigen::AngleAxisd(-arm.hand_mark_tilt, Vector3d::UnitX()));
    out += print_geom(mark, X_LM);
    constexpr double kPlateThickness = 0.002;  // m
    constexpr double kPlateBorder = 0.0025;    // m
    const Eigen::Isometry3d X_LP = X_LM * Eigen::Translation3d(0.0, kPrintThickness + 0.5 * kPlateThickness, 0.0);
    out += "<geom name=\"hand_mark_plate\" " + placed(X_LP) + " " +
           box({mark.size + 2 * kPlateBorder, kPlateThickness, mark.size + 2 * kPlateBorder}) + " mass=\"0.005\" " +
           coloured(kDark) + " material=\"matt\" " + kArmContact + "/>\n";
    const Vector3d stalk_foot(0.0, palm_front - 0.004, 0.0);
    const Vector3d stalk_head = X_LP * Vector3d(0.0, 0.005, -0.004);
    out += "<geom name=\"hand_mark_stalk\" type=\"capsule\" size=\"0.0025\" fromto=\"" + mjcf(stalk_foot) + " " +
           mjcf(stalk_head) + "\" mass=\"0.005\" " + coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  }
  out += std::string("<site ") + named(kGripSite) + " " + at({0.0, arm.forearm, 0.0}) +
         " size=\"0.001\" rgba=\"0 0 0 0\"/>\n";
  out += finger_body(arm, settings, kLeftFinger, -1.0) + finger_body(arm, settings, kRightFinger, 1.0);
  return out + "</body>\n";
}

std::string arm_bodies(const robot::RobotDescription& robot, const Settings& settings) {
  const ArmDescription arm = true_arm(robot, settings);
  std::string out = "<body name=\"column\" " + placed(robot::arm_base_pose(arm)) +
                    ">\n<geom name=\"column\" type=\"cylinder\" size=\"0.022 " + mjcf(0.5 * (arm.column - 0.025)) +
                    "\" " + at({0.0, 0.0, 0.5 * (arm.column - 0.025)}) + " " + coloured(kDark) + " material=\"matt\" " +
                    kArmContact + "/>\n";
  out += "<body name=\"turret\" " + at({0.0, 0.0, arm.column}) +
         "><joint name=\"yaw\" axis=\"0 0 1\" armature=\"0.15\" damping=\"60\"/>\n";
  out += std::string("<geom name=\"turret\" type=\"cylinder\" size=\"0.024 0.012\" pos=\"0 0 -0.012\" mass=\"0.1\" ") +
         coloured(kMetal) + " material=\"matt\" " + kArmContact + "/>\n";
  out += "<body name=\"upper_arm\"><joint name=\"shoulder\" axis=\"1 0 0\" armature=\"0.15\" damping=\"60\"/>\n";
  out += "<geom name=\"upper_arm\" " + at({0.0, 0.5 * arm.upper_arm, 0.0}) + " " +
         box({0.026, arm.upper_arm + 0.02, 0.024}) + " mass=\"0.2\" " + coloured(kMetal) + " material=\"matt\" " +
         kArmContact + "/>\n";
  out += forearm_body(robot, arm, settings);
  return out + "</body></body></body>\n";
}

// The robot's base and all that it carries: a body whose place the wheels decide, and no force. It is a box up to the
// plate that the arm stands on, and a mast that carries the cameras; its frame is C.
std::string robot_body(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings) {
  constexpr double kGroundClearance = 0.06;  // m
  const Vector3d p_RC = robot.cameras.p_RC;
  const double plate_z = robot.arm->p_CA.z();
  const double body_height = plate_z - scene.room.floor_z - kGroundClearance;
  Vector3d size(0.36, 0.40, body_height);
  Vector3d centre(robot.arm->p_CA.x(), robot.arm->p_CA.y() - 0.14, plate_z - 0.5 * body_height);
  if (robot.base) {
    size.head<2>() << 2.0 * robot.base->half_width, robot.base->front + robot.base->rear;
    centre.head<2>() << p_RC.y(), 0.5 * (robot.base->front - robot.base->rear) - p_RC.x();
  }
  std::string out = std::string("<body ") + named(kRobotBase) + ">\n";
  const auto joint = [&](const char* name, const char* kind_and_axis) {
    out += std::string("<joint ") + named(name) + " " + kind_and_axis + " armature=\"" + mjcf(kBaseInertia) + "\"/>\n";
  };
  joint(kBaseJoints[0], "type=\"slide\" axis=\"1 0 0\"");
  joint(kBaseJoints[1], "type=\"slide\" axis=\"0 1 0\"");
  joint(kBaseJoints[2], "type=\"hinge\" axis=\"0 0 1\"");
  out += "<geom name=\"robot_base\" " + at(centre) + " " + box(size) + " " + coloured({0.24, 0.25, 0.27}) +
         " material=\"matt\" " + kBaseContact + "/>\n";
  out += "<geom name=\"mast\" " + at({0.5 * robot.cameras.stereo.baseline, -0.16, 0.5 * plate_z}) + " " +
         box({0.03, 0.03, -plate_z}) + " " + coloured(kMetal) + " material=\"matt\" " + kBaseContact + "/>\n";
  return out + cameras_of(robot.cameras) + arm_bodies(robot, settings) + "</body>\n";
}

}  // namespace

std::string print_name(const std::string& mark) {
  return "print:" + mark;
}

ArmDescription true_arm(const robot::RobotDescription& robot, const Settings& settings) {
  if (!robot.arm)
    throw ConfigurationError("the simulator's robot has no arm; allowed: a robot.yaml with section 'arm'");
  ArmDescription arm = *robot.arm;
  arm.p_CA += Vector3d(settings.calibration.arm_x, settings.calibration.arm_y, settings.calibration.arm_z);
  arm.yaw_CA += settings.calibration.arm_yaw_deg * kRadiansPerDegree;
  arm.column *= settings.arm.link_scale;
  arm.upper_arm *= settings.arm.link_scale;
  arm.forearm *= settings.arm.link_scale;
  return arm;
}

Eigen::Isometry3d book_pose(const Scene& scene, const Settings& settings, const BookScene& book) {
  const BooksScene& books = scene.books;
  Eigen::Isometry3d X_SB = Eigen::Isometry3d::Identity();
  X_SB.translation() = marks_middle(scene, settings) + Vector3d(book.place * books.spacing, 0.0, 0.0);
  X_SB.rotate(Eigen::AngleAxisd(settings.books.slant_deg * kRadiansPerDegree, Vector3d::UnitZ()));
  X_SB.translate(
      Vector3d(0.0, kPrintThickness + 0.5 * books.size[1], scene.shelf.top_z + 0.5 * books.size[2] - books.mark_z));
  return X_SB;
}

SceneModel write_scene_model(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                             std::uint64_t seed) {
  check_cameras(robot.cameras);
  SceneModel model;
  model.mjcf = header(robot.cameras, scene.light.ambient);
  model.mjcf += assets(model, robot, scene);
  model.mjcf += "<worldbody>\n" + lamps(scene.light, settings.light.vary, seed) + room_geoms(scene) +
                furniture_geoms(scene, settings) + robot_body(robot, scene, settings);
  for (const BookScene& book : scene.books.row) model.mjcf += book_body(robot, scene, settings, book);
  model.mjcf += obstacle_body();
  // One motor drives both fingers, as in a parallel gripper: they stay at equal distance from the middle.
  model.mjcf += std::string("</worldbody>\n<equality><joint joint1=\"") + kLeftFinger + "\" joint2=\"" + kRightFinger +
                "\" solref=\"0.005 1\"/></equality>\n</mujoco>\n";
  return model;
}

}  // namespace markservo::simulator
