#pragma once

#include <cstdint>

namespace markservo::recorder {

// How soon the next lcm-logger begins where one has died. It never gives up: what comes after an attack is wanted most.
class RestartPace {
 public:
  // One died that had lived so long: how long to wait, us. Not at all, and, where more die soon after their start, 0.5,
  // 1 and then always 2 s.
  std::int64_t pause_us(std::int64_t lived_us);

 private:
  int crashes_ = 0;  // in a row
};

}  // namespace markservo::recorder
