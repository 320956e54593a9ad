#include "services/stereo-camera/files/schedule.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace markservo::stereo_camera {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second

}  // namespace

std::int64_t time_of(std::int64_t start_us, std::int64_t n, double rate_hz) {
  if (!(rate_hz > 0.0)) {
    throw std::invalid_argument("time_of: rate is " + std::to_string(rate_hz) + " Hz; allowed: above 0");
  }
  return start_us + static_cast<std::int64_t>(std::llround(kMicroseconds * static_cast<double>(n) / rate_hz));
}

std::int64_t Schedule::due(std::int64_t index, std::int64_t now_us) {
  const std::int64_t planned = time_of(start_us_, index, rate_hz_);
  const std::int64_t late = now_us - planned;
  if (late <= time_of(0, 1, rate_hz_)) return planned;
  start_us_ += late;
  return now_us;
}

}  // namespace markservo::stereo_camera
