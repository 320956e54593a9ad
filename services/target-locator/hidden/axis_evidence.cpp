#include "services/target-locator/hidden/axis_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace markservo::target_locator {
namespace {

// A coordinate and how likely it is beside others.
struct Possibility {
  double weight = 0.0;
  AxisCoordinate centre;
};

// The mean of all that are likely enough, with a variance that spans them.
AxisCoordinate mixture(const std::array<Possibility, 3>& possibilities, double unlikely) {
  double all = 0.0;
  for (const Possibility& possibility : possibilities) all += possibility.weight;
  double sum = 0.0;
  AxisCoordinate mixed;
  for (const Possibility& possibility : possibilities) {
    if (possibility.weight < unlikely * all) continue;
    sum += possibility.weight;
    mixed.mean += possibility.weight * possibility.centre.mean;
  }
  mixed.mean /= sum;
  for (const Possibility& possibility : possibilities) {
    if (possibility.weight < unlikely * all) continue;
    const double off = possibility.centre.mean - mixed.mean;
    mixed.variance += possibility.weight / sum * (possibility.centre.variance + off * off);
  }
  return mixed;
}

}  // namespace

AxisEvidence::AxisEvidence(const PlaneOutlines& outlines, const Eigen::Vector2d& axis, double separation,
                           double crossings, double size, const HiddenSidesParameters& parameters)
    : size_(size), pixel_(outlines.pixel), parameters_(parameters) {
  // A side along the pixels is known to the pixel it lies in; one across them averages that.
  const double rounding = 1.0 / (12.0 * std::pow(1.0 + crossings, 2));
  edge_variance_ = (std::pow(parameters.edge_floor_px, 2) + rounding) * pixel_ * pixel_;
  // Across such an edge.
  apart_ = separation * std::abs(axis.x());
  low_ = side(outlines, -axis);
  high_ = side(outlines, axis);
  low_.out = -low_.out;
}

std::optional<AxisCoordinate> AxisEvidence::centre() const {
  const double extent = high_.out - low_.out;
  const double middle = 0.5 * (low_.out + high_.out);
  const double edge = edge_variance_;
  const double missing = size_ - extent;
  if (missing < -parameters_.most_too_large * size_ - pixel_) return std::nullopt;
  if (missing <= parameters_.size_tolerance * size_ + 0.5 * pixel_) {
    return AxisCoordinate{middle, 0.5 * edge + missing * missing / 12.0};
  }
  // At least one of the two is hidden.
  const double size_variance = std::pow(0.5 * parameters_.size_sigma * size_, 2);
  const Possibility by_low{low_.likely * (1.0 - high_.likely), {low_.out + 0.5 * size_, edge + size_variance}};
  const Possibility by_high{high_.likely * (1.0 - low_.likely), {high_.out - 0.5 * size_, edge + size_variance}};
  const Possibility between{parameters_.two_things * (1.0 - low_.likely) * (1.0 - high_.likely),
                            {middle, missing * missing / 12.0 + edge}};
  return mixture({by_low, by_high, between}, parameters_.unlikely);
}

// The outermost edge of either view.
AxisEvidence::Side AxisEvidence::side(const PlaneOutlines& outlines, const Eigen::Vector2d& outwards) const {
  constexpr double kTip = 0.02;  // likely to be a side
  constexpr double kEither = 0.5;
  constexpr double kSeenByBoth = 0.99;
  std::array<OutermostEdge, 2> edges;
  for (std::size_t view = 0; view < 2; ++view) {
    edges[view] = outermost_edge(outlines.views[view], outwards, pixel_);
  }
  const bool left_is_outer = edges[0].out >= edges[1].out;
  const OutermostEdge& outer = left_is_outer ? edges[0] : edges[1];
  const OutermostEdge& inner = left_is_outer ? edges[1] : edges[0];
  const double tolerance = 1.0 * pixel_;
  if (!is_straight(outer)) return {outer.out, kTip};
  const bool both = is_straight(inner) && outer.out - inner.out <= tolerance;
  if (!both) return {outer.out, kEither};
  return {0.5 * (outer.out + inner.out), apart_ > 2.0 * tolerance ? kSeenByBoth : kEither};
}

bool AxisEvidence::is_straight(const OutermostEdge& edge) const {
  const double crooked = std::max(parameters_.crooked_rad, 3.0 * edge.slope_sigma);
  return edge.length >= parameters_.least_length * size_ && std::abs(edge.slope) <= crooked && edge.rms <= pixel_;
}

}  // namespace markservo::target_locator
