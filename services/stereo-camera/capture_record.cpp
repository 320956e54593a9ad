#include "services/stereo-camera/capture_record.hpp"

#include <utility>

namespace markservo::stereo_camera {

void CaptureRecord::drop(const std::string& reason, std::int64_t pairs) {
  dropped_ += pairs;
  last_reason_ = reason;
}

bool CaptureRecord::wait(bool waiting, const std::string& reason) {
  if (waiting && !reason.empty()) last_reason_ = reason;
  return std::exchange(waiting_, waiting) != waiting;
}

CaptureRecord::Health CaptureRecord::next_health() {
  const std::int64_t newly_dropped = dropped_ - std::exchange(dropped_told_, dropped_);
  if (waiting_) return {"waiting", last_reason_ + " (lost " + std::to_string(losses_) + " times)"};
  if (newly_dropped == 0) return {"ready", ""};
  return {"ready", std::to_string(newly_dropped) + " pairs dropped in the last second, " + std::to_string(dropped_) +
                       " since the start; last: " + last_reason_};
}

}  // namespace markservo::stereo_camera
