#include "services/simulator/model/scene_model.hpp"

#include <utility>

#include "services/simulator/arm/arm_mjcf.hpp"
#include "services/simulator/arm/gripper_mjcf.hpp"
#include "services/simulator/base/base_mjcf.hpp"
#include "services/simulator/cameras/camera_mjcf.hpp"
#include "services/simulator/marks/mark_mjcf.hpp"
#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/model/time_step.hpp"
#include "services/simulator/scene/book_mjcf.hpp"
#include "services/simulator/scene/lamp_mjcf.hpp"
#include "services/simulator/scene/obstacle.hpp"
#include "services/simulator/scene/room_mjcf.hpp"

namespace markservo::simulator {
namespace {

const Rgb kWood(0.47, 0.40, 0.34);

// MuJoCo's solver ends when the rest no longer matters beside the mean of all joints' inertia. The base's own, which
// stands for "moved by nothing", must not count: this is the mean over arm and books.
constexpr double kMeanInertia = 0.164;

std::string header(const robot::CameraDescription& cameras, double ambient) {
  const std::string grey = mjcf(Eigen::Vector3d(ambient, ambient, ambient));
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
         mjcf(vertical_view_deg(cameras)) +
         "\"/><quality offsamples=\"4\" shadowsize=\"0\"/>"
         "<map znear=\"0.02\" zfar=\"20\"/><headlight ambient=\"" +
         grey + "\" diffuse=\"0 0 0\" specular=\"0 0 0\"/></visual>\n";
}

// How a surface throws light back.
struct Finish {
  double specular = 0.0;
  double shininess = 0.0;
};

std::string textured(SceneModel& model, const std::string& name, Texture texture, const Finish& finish = {}) {
  const std::string edge = std::to_string(texture.edge);
  model.textures[name] = std::move(texture);
  return "<texture " + named(name) + " type=\"2d\" builtin=\"flat\" rgb1=\"1 1 1\" width=\"" + edge + "\" height=\"" +
         edge + "\"/><material " + named(name) + " texture=\"" + name + "\" specular=\"" + mjcf(finish.specular) +
         "\" shininess=\"" + mjcf(finish.shininess) + "\"/>\n";
}

std::string assets(SceneModel& model, const robot::RobotDescription& robot, const Scene& scene, MarkLook look) {
  constexpr int kPrintEdge_px = 256;
  constexpr int kWallEdge_px = 512;
  std::string out = "<asset>\n<material name=\"matt\" specular=\"0.05\" shininess=\"0.1\"/>\n";
  constexpr Finish kGloss{0.6, 0.4};
  const Finish finish = look == MarkLook::kGlossy ? kGloss : Finish{};
  for (const auto& mark : robot.marks) {
    out += textured(model, print_name(mark.name), mark_texture(mark, scene.print, kPrintEdge_px, look), finish);
  }
  out += textured(model, "wall", surface_texture(scene.room.wall, 0.35, "wall", kWallEdge_px));
  out += textured(model, "floor", surface_texture(scene.room.floor, 0.4, "floor", kWallEdge_px));
  out += textured(model, "wood", surface_texture(kWood, 0.3, "wood", kPrintEdge_px));
  return out + "</asset>\n";
}

}  // namespace

SceneModel write_scene_model(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                             std::uint64_t seed) {
  require_drawable(robot.cameras);
  const robot::ArmDescription arm = true_arm(arm_of(robot), settings.calibration, settings.arm);
  const std::string carried = camera_pair(robot.cameras) + arm_bodies(robot, arm, settings.gripper);
  SceneModel model;
  model.mjcf = header(robot.cameras, scene.light.ambient);
  model.mjcf += assets(model, robot, scene, settings.marks.look());
  model.mjcf += "<worldbody>\n" + lamps(scene.light, settings.light.vary, seed) + room_geoms(scene) +
                furniture_geoms(scene, settings.books) + robot_body(robot, scene.room.floor_z, carried);
  for (const BookScene& book : scene.books.row) model.mjcf += book_body(robot, scene, settings.books, book);
  model.mjcf += obstacle_body();
  model.mjcf += "</worldbody>\n<equality>" + gripper_equality() + "</equality>\n</mujoco>\n";
  return model;
}

}  // namespace markservo::simulator
