#pragma once

// Which frames of two free-running cameras show the same moment, and when that was.

#include <cstdint>

namespace markservo::stereo_camera {

enum class Pairing {
  kPair,       // at most half a frame apart: no other frame is nearer
  kDropLeft,   // the left frame is too old: take the next left one
  kDropRight,  // the right frame is too old
};

// Judges two frame times of one clock (us) at `frame_period_us` (above 0, else std::invalid_argument).
Pairing pair_frames(std::int64_t left_us, std::int64_t right_us, std::int64_t frame_period_us);

// What a clock of the host says at one moment, us.
struct ClockReading {
  std::int64_t monotonic_us = 0;  // CLOCK_MONOTONIC, which most drivers stamp frames with
  std::int64_t realtime_us = 0;   // since the epoch
};

// A driver's frame time on the realtime clock, us since the epoch. Takes it as monotonic or as realtime, whichever puts
// the frame into the last `kMaxFrameAge_us`; where neither does (a driver without frame times says 0), it is `now`.
struct FrameTime {
  std::int64_t utime = 0;
  bool from_driver = false;
};
FrameTime frame_time(std::int64_t driver_us, const ClockReading& now);

inline constexpr std::int64_t kMaxFrameAge_us = 5'000'000;  // a frame older than this is a wrong clock, not a slow read

}  // namespace markservo::stereo_camera
