#include "common/messages/message_identity.hpp"

namespace markservo::messages {
namespace {

std::string wrong_number(const char* field, std::int64_t value, const std::string& allowed) {
  return std::string(field) + " is " + std::to_string(value) + "; allowed: " + allowed;
}

bool possible(std::int64_t count) {
  return count >= 0 && count <= kMaxCount;
}

}  // namespace

std::string violation(const Identity& identity) {
  const auto& [utime, session, seq, frame_utime, frame_seq] = identity;
  if (utime && !possible(*utime)) return wrong_number("utime", *utime, "0 to 2^53 us");
  if (session && *session < 1) return wrong_number("session", *session, "1 or more");
  if (seq && !possible(*seq)) return wrong_number("seq", *seq, "0 to 2^53");
  if (frame_utime && frame_utime != utime) {
    return wrong_number("frame_utime", *frame_utime, "utime, " + std::to_string(utime.value_or(0)));
  }
  if (frame_seq && !possible(*frame_seq)) return wrong_number("frame_seq", *frame_seq, "0 to 2^53");
  return {};
}

}  // namespace markservo::messages
