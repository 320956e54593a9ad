#pragma once

// Between messages and the protocol of common/motion.

#include <cstdint>
#include <markservo/StopRequest.hpp>
#include <stdexcept>
#include <string>

#include "common/motion/conflict_guard.hpp"
#include "common/motion/stamp.hpp"

namespace markservo::messages {

// What a stream's message says of itself.
template <class M>
motion::Stamp stamp_of(const M& message) {
  return {message.session, message.seq, message.utime};
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
