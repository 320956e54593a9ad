#pragma once

// Decoding that no message can hurt: any bytes give a message or a reason, never an exception, never an allocation
// larger than the message justifies (lcmtypes/HardenGeneratedType.cmake bounds the generated code's lengths).

#include <lcm/lcm_coretypes.h>
#include <cstdint>

#include <exception>
#include <limits>
#include <string>

namespace markservo::bus {

template <class M>
struct Decoded {
  bool ok = false;
  M message{};
  std::string error;  // why not
};

template <class M>
Decoded<M> safe_decode(const void* data, std::size_t size) {
  Decoded<M> result;
  constexpr std::size_t kHashSize = 8;
  if (size < kHashSize) {
    result.error = "message of " + std::to_string(size) + " bytes is shorter than a type's fingerprint";
    return result;
  }
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    result.error = "message is larger than 2 GiB";
    return result;
  }
  int64_t fingerprint = 0;
  __int64_t_decode_array(data, 0, static_cast<int>(kHashSize), &fingerprint, 1);
  if (fingerprint != M::getHash()) {
    result.error = std::string("message is of another type than ") + M::getTypeName();
    return result;
  }
  try {
    const int used = result.message.decode(data, 0, static_cast<int>(size));
    if (used < 0) {
      result.error = std::string(M::getTypeName()) + " is truncated or has an impossible length";
    } else if (static_cast<std::size_t>(used) != size) {
      result.error = std::string(M::getTypeName()) + " has " + std::to_string(size - static_cast<std::size_t>(used)) +
                     " bytes too many";
    } else {
      result.ok = true;
    }
  } catch (const std::exception& error) {
    result.error = std::string(M::getTypeName()) + " cannot be decoded: " + error.what();
  }
  return result;
}

}  // namespace markservo::bus
