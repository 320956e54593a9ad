#include "services/target-locator/outline/square_side.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace markservo::target_locator {
namespace {

constexpr int kLevelFrom = 3;  // px from the line, beyond its blur
constexpr int kLevelTo = 5;

// Turns the side to the line through the points; false when too few of those wanted lie on it.
bool fit_line(EdgePoints& points, int wanted, float tolerance, const SideParameters& parameters, SquareSide& side) {
  const auto line = fit_edge_line(points, tolerance);
  if (!line) return false;
  side.p += line->p;
  side.q += line->q;
  side.rms = line->rms;
  side.covariance = line->covariance;
  return static_cast<double>(line->good) >= parameters.min_good_share * wanted;
}

// The whole positions along a side.
struct Steps {
  int first = 0;
  int count = 0;
};

Steps steps_of(const SquareSide& side) {
  const int first = static_cast<int>(std::ceil(side.from));
  return {first, static_cast<int>(std::floor(side.to)) - first + 1};
}

}  // namespace

SquareSide side_of(const ImageLine& line, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double corner_share) {
  SquareSide side;
  side.upright = std::abs(line.n.x()) >= std::abs(line.n.y());
  const double across = side.upright ? line.n.x() : line.n.y();
  const double along = side.upright ? line.n.y() : line.n.x();
  side.inside_after = across < 0.0;  // the normal points outwards
  const double start = side.upright ? std::min(a.y(), b.y()) : std::min(a.x(), b.x());
  const double end = side.upright ? std::max(a.y(), b.y()) : std::max(a.x(), b.x());
  const double cut = corner_share * (end - start);
  side.from = start + cut;
  side.to = end - cut;
  side.middle = 0.5 * (start + end);
  side.q = -along / across;
  side.p = line.c / across + side.q * side.middle;
  return side;
}

ImageLine line_of(const SquareSide& side, double p, double q) {
  // across - q along = p - q middle
  return side.upright ? ImageLine{{1.0, -q}, p - q * side.middle} : ImageLine{{-q, 1.0}, p - q * side.middle};
}

bool fit_to_mask(const Mask& lines, const SideParameters& parameters, EdgePoints& points, SquareSide& side) {
  constexpr int kReach = 6;
  constexpr int kAgreeing = 3;  // pixels that follow each other make a beginning
  const Steps steps = steps_of(side);
  points.clear();
  for (int along = std::max(0, steps.first); along < std::min(lines.height(), steps.first + steps.count); ++along) {
    const double across = side.across(along);
    const int start = static_cast<int>(std::lround(across));
    // From outside inwards.
    const int begin = side.inside_after ? start - kReach : start - kReach - (kAgreeing - 1);
    std::uint64_t bits = lines.window(begin, along) & imaging::low_bits(2 * kReach + kAgreeing);
    bits &= (bits >> 1) & (bits >> 2);
    if (bits == 0) continue;
    const int inner = side.inside_after ? __builtin_ctzll(bits) : 63 - __builtin_clzll(bits);
    if (inner == (side.inside_after ? 0 : 2 * kReach)) continue;  // it may begin further out
    const double edge = side.inside_after ? begin + inner - 0.5 : begin + inner + (kAgreeing - 1) + 0.5;
    points.push_back({static_cast<float>(along - side.middle), static_cast<float>(edge - across), 0.0F, true});
  }
  constexpr float kTolerance = 0.8F;  // px
  return fit_line(points, std::max(steps.count, 6), kTolerance, parameters, side);
}

bool fit_to_contrast(const PlaneImage& contrast, const SideParameters& parameters, EdgePoints& points,
                     SquareSide& side) {
  const Steps steps = steps_of(side);
  const int limit_along = side.upright ? contrast.height : contrast.width;
  const int limit_across = side.upright ? contrast.width : contrast.height;
  const std::ptrdiff_t step = side.upright ? 1 : contrast.stride();
  const auto min_span = static_cast<float>(parameters.min_span);
  points.clear();
  for (int along = std::max(0, steps.first); along < std::min(limit_along, steps.first + steps.count); ++along) {
    const double expected = side.across(along);
    const int middle = static_cast<int>(std::lround(expected));
    // The margin around the mark may be as little as three pixels; levels come from what there is.
    const int reach_before = std::min(kLevelTo, middle);
    const int reach_after = std::min(kLevelTo, limit_across - 1 - middle);
    if (reach_before < kLevelFrom || reach_after < kLevelFrom) continue;
    const float* centre = side.upright ? contrast.row(along) + middle : contrast.row(middle) + along;
    float before = 0.0F;
    float after = 0.0F;
    if (reach_before == kLevelTo && reach_after == kLevelTo) {
      before = (centre[-3 * step] + centre[-4 * step] + centre[-5 * step]) * (1.0F / 3.0F);
      after = (centre[3 * step] + centre[4 * step] + centre[5 * step]) * (1.0F / 3.0F);
    } else {
      for (int d = kLevelFrom; d <= reach_before; ++d) before += centre[-d * step];
      for (int d = kLevelFrom; d <= reach_after; ++d) after += centre[d * step];
      before /= static_cast<float>(reach_before - kLevelFrom + 1);
      after /= static_cast<float>(reach_after - kLevelFrom + 1);
    }
    const float span = side.inside_after ? after - before : before - after;
    if (span < min_span) continue;
    const float sum = centre[-2 * step] + centre[-step] + centre[0] + centre[step] + centre[2 * step];
    // Of the five pixels, this many lie on the `after` side of the step.
    const float share = (sum - 5.0F * before) / (after - before);
    const float off = 2.5F - share;
    if (std::abs(off) > 2.5F) continue;
    points.push_back(
        {static_cast<float>(along - side.middle), static_cast<float>(middle - expected) + off, 0.0F, true});
  }
  constexpr float kTolerance = 0.15F;  // px
  return fit_line(points, std::max(steps.count, 6), kTolerance, parameters, side) && side.rms <= parameters.max_rms_px;
}

}  // namespace markservo::target_locator
