#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace markservo::bus {

// One encoded message on its way out.
struct Outgoing {
  const std::string& channel;  // with the robot's prefix
  const void* data;
  std::size_t size;    // bytes
  std::int64_t utime;  // us, the time of what it tells; 0: it tells none
};

}  // namespace markservo::bus
