#include "common/motion/stop_latch.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

StopHeard StopLatch::hear(const StopRequestStamp& request, std::int64_t now, const std::string& obstacle) {
  latched_at_ = std::min(latched_at_, now);  // a clock that was set back
  if (request.reset && request.stamp.utime < latched_at_) return StopHeard::kStale;
  switch (inbox_.hear(request.stamp, now, !request.reset)) {
    case CommandHeard::kAgain:
      // A sender that counts badly is to be obeyed all the same.
      if (request.reset || latched_) return StopHeard::kAgain;
      break;
    case CommandHeard::kStale:
      return StopHeard::kStale;
    case CommandHeard::kExecute:
      break;
  }
  if (request.reset && !obstacle.empty()) {
    latch(obstacle, now);
    return StopHeard::kRefused;
  }
  if (!request.reset) latched_at_ = now;
  latched_ = !request.reset;
  reason_ = request.words;
  return request.reset ? StopHeard::kReleased : StopHeard::kLatched;
}

std::string StopLatch::why_stale(const StopRequestStamp& request, std::int64_t now) const {
  const std::string out_of_time = inbox_.why_stale(request.stamp, now);
  if (!out_of_time.empty() || !request.reset || request.stamp.utime >= latched_at_) return out_of_time;
  return fmt::format("it is of {:.2f} s before the newest STOP", -seconds_between(latched_at_, request.stamp.utime));
}

void StopLatch::latch(const std::string& reason, std::int64_t now) {
  if (!latched_) latched_at_ = now;
  latched_ = true;
  reason_ = reason;
}

}  // namespace markservo::motion
