#pragma once

// Between messages and the protocol of common/motion.

#include <cstdint>
#include <markservo/StopRequest.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/motion/conflict_guard.hpp"
#include "common/motion/stamp.hpp"

namespace markservo::messages {

// A digest of all that a message says (FNV-1a, 64 bits, of its encoding; never 0): by it a repetition is told from what
// another one says under the same number.
template <class M>
std::uint64_t content_of(const M& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  std::uint64_t digest = 0xcbf29ce484222325;
  for (const std::uint8_t byte : bytes) digest = (digest ^ byte) * 0x100000001b3;
  return digest == 0 ? 1 : digest;
}

// What a stream's message says of itself.
template <class M>
motion::Stamp stamp_of(const M& message) {
  return {message.session, message.seq, message.utime, content_of(message)};
}

// The stamp of a JOINT_COMMAND: its age is that of the picture that it answers.
template <class M>
motion::Stamp command_stamp(const M& command) {
  return {command.session, command.seq, command.frame_utime, content_of(command)};
}

// The STOP that a reader asks for when two claim to be one. `session` and `source`: the reader's own.
inline StopRequest stop_request(const motion::StopWish& wish, std::int64_t utime, std::int64_t session,
                                const std::string& source) {
  StopRequest stop{};
  stop.utime = utime;
  stop.session = session;
  stop.request_id = wish.id;
  stop.kind = StopRequest::STOP;
  stop.source = source;
  stop.reason = wish.reason;
  return stop;
}

// Lets the bus count a message as refused, with the reason; does nothing when there is none.
inline void drop(const std::string& why) {
  if (!why.empty()) throw std::invalid_argument(why);
}

}  // namespace markservo::messages
