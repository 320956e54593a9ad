#include "services/stereo-camera/pairs/frame_pairing.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace markservo::stereo_camera {
namespace {

constexpr std::int64_t kAhead_us = 1000;  // between reading the two clocks a frame's time may seem to lie ahead

bool recent(std::int64_t time_us, std::int64_t now_us) {
  return time_us > 0 && time_us <= now_us + kAhead_us && time_us >= now_us - kMaxFrameAge_us;
}

}  // namespace

Pairing pair_frames(std::int64_t left_us, std::int64_t right_us, std::int64_t frame_period_us) {
  if (frame_period_us <= 0) {
    throw std::invalid_argument("pair_frames: frame period is " + std::to_string(frame_period_us) +
                                " us; allowed: above 0");
  }
  if (2 * std::llabs(left_us - right_us) <= frame_period_us) return Pairing::kPair;
  return left_us < right_us ? Pairing::kDropLeft : Pairing::kDropRight;
}

FrameTime frame_time(std::int64_t driver_us, const ClockReading& now) {
  if (recent(driver_us, now.monotonic_us)) return {now.realtime_us - (now.monotonic_us - driver_us), true};
  if (recent(driver_us, now.realtime_us)) return {driver_us, true};
  return {now.realtime_us, false};
}

}  // namespace markservo::stereo_camera
