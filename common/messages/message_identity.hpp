#pragma once

// What messages say of themselves, whatever their type: a possible time, in streams a session and a number, and in an
// answer the frame's time as its own.

#include <cstdint>
#include <optional>
#include <string>

#include "common/messages/message_traits.hpp"

namespace markservo::messages {

// Times (us) and numbers beyond this are not real: the year 2255, or 9 million years at 30 Hz. Sums of a few never
// overflow, and every one is exact as a double.
inline constexpr std::int64_t kMaxCount = std::int64_t{1} << 53;

// Nothing where the type has no such field.
struct Identity {
  std::optional<std::int64_t> utime;        // us
  std::optional<std::int64_t> session;      // of a stream, as
  std::optional<std::int64_t> seq;          // this
  std::optional<std::int64_t> frame_utime;  // us, of an answer, as
  std::optional<std::int64_t> frame_seq;    // this
};

template <class M>
Identity identity_of(const M& message) {
  Identity identity;
  if constexpr (has_utime<M>::value) identity.utime = message.utime;
  if constexpr (has_seq<M>::value) {
    identity.session = message.session;
    identity.seq = message.seq;
  }
  if constexpr (answers_frame<M>::value) {
    identity.frame_utime = message.frame_utime;
    identity.frame_seq = message.frame_seq;
  }
  return identity;
}

// Which field is impossible, its value and what is allowed; empty if none is.
std::string violation(const Identity& identity);

}  // namespace markservo::messages
