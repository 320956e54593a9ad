#pragma once

// The room around the robot as MuJoCo's MJCF: walls, furniture, and an obstacle that can be put in the robot's way.

#include <string>

#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"

namespace markservo::simulator {

// Name of the obstacle's body and box: a mocap body, so that it is wherever it is put and nothing moves it.
inline constexpr const char* kObstacle = "obstacle";
inline constexpr double kObstacleHeight = 1.7;  // m, a person's

// Bodies and geoms in S. Needs the materials wall, floor, wood and matt.
std::string room_geoms(const Scene& scene);
std::string furniture_geoms(const Scene& scene, const Settings& settings);
std::string obstacle_body();

}  // namespace markservo::simulator
