#pragma once

#include <string>

namespace markservo::simulator {

// Name of the obstacle's body and box: a mocap body, so that it is wherever it is put and nothing moves it.
inline constexpr const char* kObstacle = "obstacle";
inline constexpr double kObstacleHeight = 1.7;  // m, a person's

// As MuJoCo's MJCF. Needs the material matt.
std::string obstacle_body();

}  // namespace markservo::simulator
