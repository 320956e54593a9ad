#include "common/motion/stop_latch.hpp"

namespace markservo::motion {

StopHeard StopLatch::hear(const StopRequestStamp& request, std::int64_t now, const std::string& obstacle) {
  switch (inbox_.hear(request.stamp, now, !request.reset)) {
    case CommandHeard::kAgain:
      return StopHeard::kAgain;
    case CommandHeard::kStale:
      return StopHeard::kStale;
    case CommandHeard::kExecute:
      break;
  }
  if (request.reset && !obstacle.empty()) {
    latch(obstacle);
    return StopHeard::kRefused;
  }
  latched_ = !request.reset;
  reason_ = request.words;
  return request.reset ? StopHeard::kReleased : StopHeard::kLatched;
}

void StopLatch::latch(const std::string& reason) {
  latched_ = true;
  reason_ = reason;
}

}  // namespace markservo::motion
