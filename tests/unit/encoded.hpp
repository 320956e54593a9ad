#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markservo::test {

// The message's bytes, as the bus carries them.
template <class M>
std::vector<std::uint8_t> encoded(const M& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

}  // namespace markservo::test
