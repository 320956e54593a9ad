#pragma once

#include <cstdint>

namespace markservo::motion {

// What a stream's message says of itself.
struct Stamp {
  std::int64_t session = 0;  // of its writer, 1 or more
  std::int64_t seq = 0;
  std::int64_t utime = 0;     // us, of the measurement
  std::uint64_t content = 0;  // a digest of all that the message says; 0: not known
};

}  // namespace markservo::motion
