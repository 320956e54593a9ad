#include "services/target-locator/hidden/square_turn.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry/degrees.hpp"
#include "services/target-locator/hidden/outermost_edge.hpp"

namespace markservo::target_locator {
namespace {

using geometry::kRadiansPerDegree;

// How many points lie on the outermost lines of that direction and its opposite, or nothing if these are farther apart
// than `most`.
std::optional<int> support(const std::vector<double>& values, double tolerance, double most) {
  const double low = nth_value(values, kStrays);
  const double high = nth_value(values, values.size() - 1 - kStrays);
  if (high - low > most) return std::nullopt;
  return static_cast<int>(std::count_if(
      values.begin(), values.end(), [&](double value) { return value < low + tolerance || value > high - tolerance; }));
}

}  // namespace

std::optional<double> best_turn(const PlaneOutlines& outlines, double most_extent) {
  Points all = outlines.views[0];
  all.insert(all.end(), outlines.views[1].begin(), outlines.views[1].end());
  const double tolerance = 0.9 * outlines.pixel;
  std::vector<double> values(all.size());
  double best = 0.0;
  int most = 0;
  const auto try_turn = [&](double turn) {
    int sum = 0;
    for (const Eigen::Vector2d& axis :
         {Eigen::Vector2d(std::cos(turn), std::sin(turn)), Eigen::Vector2d(-std::sin(turn), std::cos(turn))}) {
      std::transform(all.begin(), all.end(), values.begin(), [&axis](const auto& point) { return axis.dot(point); });
      const auto count = support(values, tolerance, most_extent);
      if (!count) return;
      sum += *count;
    }
    if (sum > most) {
      most = sum;
      best = turn;
    }
  };
  constexpr int kCoarse_deg = 1;
  for (int degrees = -45; degrees < 45; degrees += kCoarse_deg) try_turn(degrees * kRadiansPerDegree);
  if (most == 0) return std::nullopt;
  const double coarse = best;
  constexpr int kFineSteps = 5;
  for (int k = -kFineSteps; k <= kFineSteps; ++k) try_turn(coarse + k * 0.2 * kCoarse_deg * kRadiansPerDegree);
  return best;
}

double aligned_turn(const PlaneOutlines& outlines, double turn) {
  constexpr double kParallel = 0.006;  // rad
  std::vector<OutermostEdge> edges;
  for (int k = 0; k < 4; ++k) {
    const double angle = turn + 90.0 * kRadiansPerDegree * k;
    for (const Points& points : outlines.views) {
      edges.push_back(outermost_edge(points, {std::cos(angle), std::sin(angle)}, outlines.pixel));
    }
  }
  double most = 0.0;
  double best = 0.0;
  for (const OutermostEdge& candidate : edges) {
    double length = 0.0;
    double weights = 0.0;
    double sum = 0.0;
    for (const OutermostEdge& edge : edges) {
      if (std::abs(edge.slope - candidate.slope) > std::max(kParallel, 2.5 * edge.slope_sigma)) continue;
      const double weight = 1.0 / (edge.slope_sigma * edge.slope_sigma);
      length += edge.length;
      weights += weight;
      sum += weight * edge.slope;
    }
    if (length > most) {
      most = length;
      best = sum / weights;
    }
  }
  // A side's reach grows along it as the square turns the other way.
  return turn - best;
}

}  // namespace markservo::target_locator
