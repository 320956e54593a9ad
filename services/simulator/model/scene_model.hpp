#pragma once

// Writes the simulated world as a MuJoCo model: the robot of config/robot.yaml in a scene. The MuJoCo world frame is
// the scene frame S: the camera frame C while the robot stands at the scene's dock.

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/marks/mark_texture.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"

namespace markservo::simulator {

// Names in the model. A book's body and box are named after its mark; a mark's print is "print:" + the mark's name.
inline constexpr const char* kLeftCamera = "left";
inline constexpr const char* kRightCamera = "right";
inline constexpr const char* kGripSite = "grip_point";
inline constexpr const char* kRobotBase = "robot_base";  // the body whose frame is C
inline constexpr const char* kBaseJoints[] = {"base_x", "base_y", "base_turn"};
inline constexpr const char* kLeftFinger = "finger_left";
inline constexpr const char* kRightFinger = "finger_right";
std::string print_name(const std::string& mark);

inline constexpr double kTimeStep = 0.002;  // s

// A mark's printed face lies this far before what it is glued to. Thicker, its visible side would shift the centre.
inline constexpr double kPrintThickness = 0.0002;  // m

struct SceneModel {
  std::string mjcf;
  std::map<std::string, Texture> textures;  // by texture name, to be filled in after compiling
};

// The arm as it really is in the simulated world: robot.yaml's with the settings' calibration errors.
robot::ArmDescription true_arm(const robot::RobotDescription& robot, const Settings& settings);

// Where a book stands at a reset: X_SB of its centre.
Eigen::Isometry3d book_pose(const Scene& scene, const Settings& settings, const BookScene& book);

// Throws ConfigurationError if the cameras are not what the renderer can do: fx = fy and the principal point in the
// image's middle; or if the robot has no arm.
SceneModel write_scene_model(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                             std::uint64_t seed);

}  // namespace markservo::simulator
