#pragma once

// Decoding that no message can hurt: any bytes give a message or a reason, never an exception, never an allocation
// larger than the message justifies (lcmtypes/HardenGeneratedType.cmake bounds the generated code's lengths).

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

namespace markservo::bus {

// Why a message whose type says `theirs` of itself is none of `type`, whose fingerprint is `ours`. A fingerprint does
// not say whether it is another version of the type or another type.
std::string other_version_text(const char* type, std::int64_t theirs, std::int64_t ours);

// Why `size` bytes are no message of `type`, whose fingerprint is `ours`, before any of it is decoded; empty if they
// may be one.
std::string why_not_of(const char* type, std::int64_t ours, const void* data, std::size_t size);

// Why a message of `size` bytes was not decoded: the decoder of `type` says that it used `used` of them, or below 0.
std::string why_not_decoded(const char* type, int used, std::size_t size);
std::string why_not_decoded(const char* type, const std::exception& error);

// Decodes `data` into `message`, which may have held another: its memory is used again. Returns why not, and then
// `message` holds anything; an empty text if all is well.
template <class M>
std::string decode_into(M& message, const void* data, std::size_t size) {
  if (std::string why = why_not_of(M::getTypeName(), M::getHash(), data, size); !why.empty()) return why;
  try {
    return why_not_decoded(M::getTypeName(), message.decode(data, 0, static_cast<int>(size)), size);
  } catch (const std::exception& error) {
    return why_not_decoded(M::getTypeName(), error);
  }
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
