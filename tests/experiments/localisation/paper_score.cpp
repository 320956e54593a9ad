#include "tests/experiments/localisation/paper_score.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::experiments {

std::vector<PaperError> score_paper(const std::vector<PaperRead>& reads, const TruePath& path,
                                    const Eigen::Vector2d& p_RF, double from, double to) {
  std::vector<PaperError> errors;
  int number = 0;
  for (const PaperRead& read : reads) {
    ++number;
    if (read.time < from || read.time > to) continue;
    const PathPoint truth = path.at(read.time);
    const Eigen::Vector2d p_WF = truth.at(p_RF);
    PaperError error;
    error.read = number;
    error.time = read.time;
    error.measured = read.measured - p_WF;
    error.compensated = read.compensated - p_WF;
    error.fused = read.fused - p_WF;
    error.along = Eigen::Vector2d(std::cos(truth.heading), std::sin(truth.heading));
    errors.push_back(error);
  }
  return errors;
}

Spread absolute_spread(const std::vector<double>& values) {
  if (values.empty()) return {NAN, NAN, NAN, 0};
  Spread spread{0.0, 0.0, INFINITY, static_cast<int>(values.size())};
  for (const double value : values) {
    spread.mean += std::abs(value) / static_cast<double>(values.size());
    spread.max = std::max(spread.max, std::abs(value));
    spread.min = std::min(spread.min, std::abs(value));
  }
  return spread;
}

}  // namespace markservo::experiments
