#pragma once

// Settings `obstacle.*`: something that stands in the robot's way.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct ObstacleSettings {
  double present = 0.0;
  double x = 0.0;
  double y = 0.0;
  double size = 0.3;
};

inline constexpr Setting<ObstacleSettings> kObstacleSettings[] = {
    {"obstacle.present", &ObstacleSettings::present, 0.0, 1.0, TakesEffect::kAtOnce,
     "1: something as tall as a person stands there", true},
    {"obstacle.x", &ObstacleSettings::x, -100.0, 100.0, TakesEffect::kAtOnce, "m, its middle in W"},
    {"obstacle.y", &ObstacleSettings::y, -100.0, 100.0, TakesEffect::kAtOnce, "m, its middle in W"},
    {"obstacle.size", &ObstacleSettings::size, 0.01, 3.0, TakesEffect::kAtOnce, "m, edge of the square it stands on"},
};

}  // namespace markservo::simulator
