#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace markservo::logs {

// Bytes that somebody else holds.
struct ByteView {
  const std::uint8_t* data = nullptr;
  std::size_t size = 0;

  std::string_view text() const { return {reinterpret_cast<const char*>(data), size}; }
};

// One message of a log; refers to the log's bytes.
struct LogEvent {
  std::int64_t number = 0;  // counted by the logger
  std::int64_t utime = 0;   // us, the logger's wall clock
  std::string_view channel;
  ByteView data;  // the message, its type's fingerprint first
};

// s, from one time (us) to another. A damaged log's times may be anything: their difference need not fit an integer.
inline double seconds_apart(std::int64_t from, std::int64_t to) {
  return 1e-6 * (static_cast<double>(to) - static_cast<double>(from));
}

// Bytes of a log that belong to no event.
struct Damage {
  std::size_t offset = 0;
  std::size_t bytes = 0;
};

}  // namespace markservo::logs
