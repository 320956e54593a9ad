#include "services/stereo-camera/files/video_offset.hpp"

#include <fmt/core.h>

#include <string>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/files/motion_signal.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr std::int64_t kLongest_us = 60'000'000;  // twice the largest offset that is searched for

std::vector<MotionStep> motion_of(ImageStream& stream) {
  MotionMeter meter;
  std::int64_t first_us = 0;
  bool begun = false;
  for (StreamResult result = stream.next(); result.status != StreamStatus::kEnd; result = stream.next()) {
    if (result.status != StreamStatus::kImage) continue;
    if (!begun) first_us = result.time_us;
    begun = true;
    if (result.time_us - first_us > kLongest_us) break;
    meter.add(result.image, 1e-6 * static_cast<double>(result.time_us));
  }
  stream.rewind();
  return meter.steps();
}

std::string what_was_found(const OffsetEstimate& estimate, const OffsetParameters& parameters) {
  switch (estimate.status) {
    case OffsetStatus::kTooShort:
      return fmt::format("the videos overlap by fewer than {} pictures", parameters.least_steps + 1);
    case OffsetStatus::kTooLittle:
      return fmt::format(
          "too little moves that both videos show: what moves in them correlates by {:.2f} at best, over "
          "{:.1f} s",
          estimate.correlation, estimate.overlap_s);
    case OffsetStatus::kAmbiguous:
      return fmt::format(
          "what moves in the videos repeats itself: it correlates by {:.2f} at {:.3f} s and by {:.2f} "
          "elsewhere",
          estimate.correlation, estimate.offset_s, estimate.rival);
    case OffsetStatus::kFound:
      break;
  }
  return "";
}

}  // namespace

OffsetEstimate measure_offset(ImageStream& left, ImageStream& right) {
  const OffsetParameters parameters;
  const OffsetEstimate estimate = estimate_offset(motion_of(left), motion_of(right), parameters);
  if (estimate.status == OffsetStatus::kFound) return estimate;
  throw ConfigurationError(
      fmt::format("--estimate-offset: {}; allowed: videos of {:.0f} s or less apart in which "
                  "something large moves irregularly, or --offset-s with the offset",
                  what_was_found(estimate, parameters), parameters.max_offset_s));
}

}  // namespace markservo::stereo_camera
