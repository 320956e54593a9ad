#pragma once

#include <cstdint>

#include "services/rfid-localizer/motion.hpp"

namespace markservo::rfid_localizer {

// Where the robot may be at a time, and how it may move then.
struct Belief {
  Mixture mixture;         // empty: the robot is not placed
  std::int64_t utime = 0;  // us, that the mixture is for

  bool empty() const { return mixture.empty(); }
  void predict(const Motion& motion, std::int64_t to) {
    motion.predict(mixture, utime, to);
    utime = to;
  }
};

}  // namespace markservo::rfid_localizer
