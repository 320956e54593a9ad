#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace markservo::bus {

// A message of any type, as it came off the bus; of the moment of the call.
struct HeardBytes {
  const std::string& channel;
  const void* data;
  std::size_t size;
  std::int64_t utime;  // us, this host's wall clock when it came
};

}  // namespace markservo::bus
