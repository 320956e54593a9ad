#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <vector>

namespace markservo::fuzz {

// Other bytes at a few places, and the end cut off or drawn out: what a fuzzer does to an input, done to a message that
// its input describes.
inline void damage(FuzzedDataProvider& data, std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) return;
  const int changes = data.ConsumeIntegralInRange(0, 6);
  for (int k = 0; k < changes; ++k) {
    bytes[data.ConsumeIntegralInRange<std::size_t>(0, bytes.size() - 1)] = data.ConsumeIntegral<std::uint8_t>();
  }
  if (data.ConsumeIntegralInRange(0, 7) == 7)
    bytes.resize(data.ConsumeIntegralInRange<std::size_t>(0, bytes.size() + 8));
}

}  // namespace markservo::fuzz
