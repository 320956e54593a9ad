#pragma once

// Keeps a message from crossing twice. A bus hands a bridge what the bridge itself has put on it, and a second bridge
// between the same two buses hands it round once more: without this, a channel that crosses both ways (STOP) would
// never come to rest. No clock: "now" is given.

#include <cstddef>
#include <cstdint>
#include <deque>

namespace markservo::bus_bridge {

// Ten times what a copy needs to come back, and less than the pause between two repeats of a command (0.2 s), which are
// the same bytes and must cross.
inline constexpr std::int64_t kRepeatWindow_us = 100'000;

class RepeatFilter {
 public:
  explicit RepeatFilter(std::int64_t window_us = kRepeatWindow_us) : window_us_(window_us) {}

  // True if no message with this fingerprint (of channel and bytes) has crossed, either way, within the window before
  // `now_us`; it then crosses. Times must not go back.
  bool crosses(std::uint64_t fingerprint, std::int64_t now_us);

 private:
  static constexpr std::size_t kRemembered = 4096;  // a flood of more than 40,000 messages a second forgets earlier

  struct Crossed {
    std::uint64_t fingerprint;
    std::int64_t when_us;
  };

  std::int64_t window_us_;
  std::deque<Crossed> crossed_;  // the newest at the end
};

}  // namespace markservo::bus_bridge
