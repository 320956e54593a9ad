#pragma once

// Writes the simulated world as a MuJoCo model: the robot of config/robot.yaml in a scene, each part as its own folder
// writes it. The MuJoCo world frame is the scene frame S: the camera frame C while the robot stands at the scene's
// dock.

#include <cstdint>
#include <map>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/marks/mark_texture.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"

namespace markservo::simulator {

struct SceneModel {
  std::string mjcf;
  std::map<std::string, Texture> textures;  // by texture name, to be filled in after compiling
};

// Throws ConfigurationError if the cameras are not what the renderer can do: fx = fy and the principal point in the
// image's middle; or if the robot has no arm.
SceneModel write_scene_model(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                             std::uint64_t seed);

}  // namespace markservo::simulator
