#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace markservo::experiments {

// The value below which `share` (0..1) of `values` lies, by nearest rank; NaN when there are none.
inline double percentile(std::vector<double> values, double share) {
  if (values.empty()) return NAN;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::min(values.size() - 1, rank == 0 ? 0 : rank - 1)];
}

inline double median(const std::vector<double>& values) {
  return percentile(values, 0.5);
}

inline double mean(const std::vector<double>& values) {
  if (values.empty()) return NAN;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

inline double maximum(const std::vector<double>& values) {
  return values.empty() ? NAN : *std::max_element(values.begin(), values.end());
}

}  // namespace markservo::experiments
