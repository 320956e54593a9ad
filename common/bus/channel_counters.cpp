#include "common/bus/channel_counters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace markservo::bus {

void LatencyWindow::add(double seconds, Time now) {
  values_[next_] = {seconds, now};
  next_ = (next_ + 1) % values_.size();
  count_ = std::min(count_ + 1, values_.size());
}

double LatencyWindow::percentile(double share, Time now) const {
  constexpr std::chrono::seconds kPresent{30};
  std::vector<double> sorted;
  for (std::size_t i = 0; i < count_; ++i) {
    if (now - values_[i].when <= kPresent) sorted.push_back(values_[i].seconds);
  }
  if (sorted.empty()) return 0.0;
  const auto rank = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(sorted.size() - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

}  // namespace markservo::bus
