#pragma once

#include <cstdint>

namespace markservo::simulator {

// What the simulator's parts on the bus know together of the run.
struct RunState {
  bool valid = true;          // false: something went wrong since the last reset
  bool world_is_new = false;  // after a reset: a frame is due at once
  std::int64_t resets = 0;    // of the world, since the start

  // The world was reset, because somebody asked for it or, `is_valid` false, because it had to be.
  void begin_anew(bool is_valid) {
    valid = is_valid;
    world_is_new = true;
    ++resets;
  }
};

}  // namespace markservo::simulator
