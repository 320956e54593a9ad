#include "services/bus-bridge/repeat_filter.hpp"

#include <algorithm>

namespace markservo::bus_bridge {

bool RepeatFilter::crosses(std::uint64_t fingerprint, std::int64_t now_us) {
  while (!crossed_.empty() && now_us - crossed_.front().when_us >= window_us_) crossed_.pop_front();
  const bool repeated =
      std::any_of(crossed_.begin(), crossed_.end(), [&](const Crossed& one) { return one.fingerprint == fingerprint; });
  if (repeated) return false;
  crossed_.push_back({fingerprint, now_us});
  if (crossed_.size() > kRemembered) crossed_.pop_front();
  return true;
}

}  // namespace markservo::bus_bridge
