#pragma once

// Decoding that no message can hurt: any bytes give a message or a reason, never an exception, never an allocation
// larger than the message justifies (lcmtypes/HardenGeneratedType.cmake bounds the generated code's lengths).

#include <lcm/lcm_coretypes.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>

namespace markservo::bus {

// Why a message whose type says `theirs` of itself is none of `type`, whose fingerprint is `ours`. A fingerprint does
// not say whether it is another version of the type or another type.
inline std::string other_version_text(const char* type, std::int64_t theirs, std::int64_t ours) {
  char fingerprints[64];
  std::snprintf(fingerprints, sizeof fingerprints, "0x%016" PRIx64 ", here it is 0x%016" PRIx64,
                static_cast<std::uint64_t>(theirs), static_cast<std::uint64_t>(ours));
  return std::string("message is of another version of ") + type + " or of another type: its fingerprint is " +
         fingerprints;
}

// Decodes `data` into `message`, which may have held another: its memory is used again. Returns why not, and then
// `message` holds anything; an empty text if all is well.
template <class M>
std::string decode_into(M& message, const void* data, std::size_t size) {
  constexpr std::size_t kHashSize = 8;
  if (size < kHashSize) return "message of " + std::to_string(size) + " bytes is shorter than a type's fingerprint";
  if (size > static_cast<std::size_t>(std::numeric_limits<int>::max())) return "message is larger than 2 GiB";
  int64_t fingerprint = 0;
  __int64_t_decode_array(data, 0, static_cast<int>(kHashSize), &fingerprint, 1);
  if (fingerprint != M::getHash()) return other_version_text(M::getTypeName(), fingerprint, M::getHash());
  try {
    const int used = message.decode(data, 0, static_cast<int>(size));
    if (used < 0) return std::string(M::getTypeName()) + " is truncated or has an impossible length";
    if (static_cast<std::size_t>(used) != size) {
      return std::string(M::getTypeName()) + " has " + std::to_string(size - static_cast<std::size_t>(used)) +
             " bytes too many";
    }
  } catch (const std::exception& error) {
    return std::string(M::getTypeName()) + " cannot be decoded: " + error.what();
  }
  return {};
}

template <class M>
struct Decoded {
  bool ok = false;
  M message{};
  std::string error;  // why not
};

template <class M>
Decoded<M> safe_decode(const void* data, std::size_t size) {
  Decoded<M> result;
  result.error = decode_into(result.message, data, size);
  result.ok = result.error.empty();
  return result;
}

}  // namespace markservo::bus
