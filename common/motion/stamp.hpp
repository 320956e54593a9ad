#pragma once

#include <cstdint>

namespace markservo::motion {

// What a stream's message says of itself.
struct Stamp {
  std::int64_t session = 0;  // of its writer, 1 or more
  std::int64_t seq = 0;
  std::int64_t utime = 0;  // us, of the measurement
};

}  // namespace markservo::motion
