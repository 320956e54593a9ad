#include "common/bus/channel_counters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace markservo::bus {

void LatencyWindow::add(double seconds) {
  values_[next_] = seconds;
  next_ = (next_ + 1) % values_.size();
  count_ = std::min(count_ + 1, values_.size());
}

double LatencyWindow::percentile(double share) const {
  if (count_ == 0) return 0.0;
  std::vector<double> sorted(values_.begin(), values_.begin() + static_cast<std::ptrdiff_t>(count_));
  const auto rank = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(count_ - 1)));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return sorted[static_cast<std::size_t>(rank)];
}

}  // namespace markservo::bus
