#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/plane_pose.hpp"

namespace markservo::simulator {

// What one sonar heard; as SonarEcho.lcm has it.
struct SonarEchoReading {
  geometry::PlanePose X_RS;  // the sonar in R: x is the beam's middle
  bool heard = false;        // false: nothing within the ring's greatest range, or the echo was lost
  double range = 0.0;        // m, the greatest range unless heard
};

// One round of all sonars; as SonarScan.lcm has it.
struct SonarReading {
  std::int64_t utime = 0;   // us
  double min_range = 0.0;   // m
  double max_range = 0.0;   // m
  double beam_width = 0.0;  // rad, full cone
  std::vector<SonarEchoReading> echoes;
};

}  // namespace markservo::simulator
