#include "services/target-locator/outline/square_outline.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

#include "services/target-locator/image/mask_moments.hpp"
#include "services/target-locator/outline/edge_line.hpp"

namespace markservo::target_locator {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A side as across = p + q * (along - middle): `along` is the row of an upright side, the column of a lying one.
struct Side {
  bool upright = true;
  bool inside_after = true;  // the mark lies at larger `across`
  double middle = 0.0;
  double p = 0.0;
  double q = 0.0;
  double from = 0.0;  // along, between the corners
  double to = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (p, q)
  double rms = 0.0;

  double across(double along) const { return p + q * (along - middle); }
};

// n . x = c with n not normalised.
struct Line {
  Eigen::Vector2d n;
  double c;
};

Line line_of(const Side& side, double p, double q) {
  // across - q along = p - q middle
  return side.upright ? Line{{1.0, -q}, p - q * side.middle} : Line{{-q, 1.0}, p - q * side.middle};
}

std::optional<Eigen::Vector2d> intersect(const Line& a, const Line& b) {
  const double determinant = a.n.x() * b.n.y() - a.n.y() * b.n.x();
  if (std::abs(determinant) < 1e-6) return std::nullopt;
  return Eigen::Vector2d((a.c * b.n.y() - b.c * a.n.y()) / determinant, (a.n.x() * b.c - b.n.x() * a.c) / determinant);
}

using Corners = std::array<Eigen::Vector2d, 4>;

std::optional<Corners> corners_of(const std::array<Line, 4>& lines) {
  Corners corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = intersect(lines[k], lines[(k + 1) % 4]);
    if (!corner) return std::nullopt;
    corners[k] = *corner;
  }
  return corners;
}

std::optional<Eigen::Vector2d> diagonals_meet(const Corners& c) {
  const Eigen::Vector2d a = c[2] - c[0];
  const Eigen::Vector2d b = c[3] - c[1];
  return intersect({{-a.y(), a.x()}, a.x() * c[0].y() - a.y() * c[0].x()},
                   {{-b.y(), b.x()}, b.x() * c[1].y() - b.y() * c[1].x()});
}

// The parallelogram with the mask's first, second and fourth moments: exact for a square under any affine map.
std::optional<std::array<Line, 4>> lines_from_moments(const Mask& mask, double min_squareness) {
  const MaskMoments m = moments_of(mask);
  if (m.n < 64.0) return std::nullopt;
  Eigen::Matrix2d moments;
  moments << m.xx, m.xy, m.xy, m.yy;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(moments);
  if (!(solver.eigenvalues()[0] > 1.0)) return std::nullopt;
  const Eigen::Matrix2d whiten = solver.operatorInverseSqrt();
  // The mean of (x' + i y')^4, with (x', y') whitened: (p x + q y)^4.
  const std::complex<double> p(whiten(0, 0), whiten(1, 0));
  const std::complex<double> q(whiten(0, 1), whiten(1, 1));
  const std::complex<double> fourth = p * p * p * p * m.fourth[0] + 4.0 * p * p * p * q * m.fourth[1] +
                                      6.0 * p * p * q * q * m.fourth[2] + 4.0 * p * q * q * q * m.fourth[3] +
                                      q * q * q * q * m.fourth[4];
  constexpr double kSquare = 2.4;  // |mean of (x + iy)^4| of a square with unit second moments
  if (std::abs(fourth) < kSquare * min_squareness) return std::nullopt;
  const double turn = std::arg(-fourth) / 4.0;
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const double angle = turn + 0.5 * kPi * static_cast<double>(k);
    const Eigen::Vector2d normal = whiten * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    lines[k] = {normal, std::sqrt(3.0) + normal.dot(m.centre)};
  }
  return lines;
}

Side side_of(const Line& line, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double corner_share) {
  Side side;
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

// Turns the side to the line through the points; false when too few of those wanted lie on it.
bool fit_line(EdgePoints& points, int wanted, float tolerance, const OutlineParameters& parameters, Side& side) {
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

Steps steps_of(const Side& side) {
  const int first = static_cast<int>(std::ceil(side.from));
  return {first, static_cast<int>(std::floor(side.to)) - first + 1};
}

// Where the mask begins near the side, to half a pixel. `lines`: the mask for an upright side, its transpose for a
// lying one.
bool fit_to_mask(const Mask& lines, const OutlineParameters& parameters, EdgePoints& points, Side& side) {
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

// Where the contrast's step lies, by its area within two and a half pixels of the line, row by row.
constexpr int kLevelFrom = 3;  // px from the line, beyond its blur
constexpr int kLevelTo = 5;
bool fit_to_contrast(const PlaneImage& contrast, const OutlineParameters& parameters, EdgePoints& points, Side& side) {
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

std::array<Line, 4> lines_of(const std::array<Side, 4>& sides) {
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) lines[k] = line_of(sides[k], sides[k].p, sides[k].q);
  return lines;
}

}  // namespace

std::optional<SquareOutline> fit_square(const PlaneImage& contrast, const Mask& mask, const PatchFrame& frame,
                                        const OutlineParameters& parameters) {
  const auto start = lines_from_moments(mask, parameters.min_squareness);
  if (!start) return std::nullopt;
  const auto rough = corners_of(*start);
  if (!rough) return std::nullopt;
  Mask columns;
  imaging::transpose(mask, columns);
  EdgePoints points;
  points.reserve(static_cast<std::size_t>(std::max(mask.width(), mask.height())));
  std::array<Side, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    // Corner k lies between sides k and k + 1.
    sides[k] = side_of((*start)[k], (*rough)[(k + 3) % 4], (*rough)[k], parameters.corner_share);
    if (sides[k].to - sides[k].from < 5.0) return std::nullopt;
    if (!fit_to_mask(sides[k].upright ? mask : columns, parameters, points, sides[k])) return std::nullopt;
    if (!fit_to_contrast(contrast, parameters, points, sides[k])) return std::nullopt;
  }
  const auto corners = corners_of(lines_of(sides));
  if (!corners) return std::nullopt;
  const auto centre = diagonals_meet(*corners);
  if (!centre || !centre->allFinite()) return std::nullopt;

  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() * parameters.centre_floor_px * parameters.centre_floor_px;
  SquareOutline outline;
  for (std::size_t k = 0; k < 4; ++k) {
    constexpr double kStep = 1e-3;
    Eigen::Matrix2d jacobian;
    for (int parameter = 0; parameter < 2; ++parameter) {
      const double step = parameter == 0 ? kStep : kStep / std::max(1.0, sides[k].to - sides[k].from);
      auto lines = lines_of(sides);
      lines[k] =
          line_of(sides[k], sides[k].p + (parameter == 0 ? step : 0.0), sides[k].q + (parameter == 1 ? step : 0.0));
      const auto moved_corners = corners_of(lines);
      const auto moved = moved_corners ? diagonals_meet(*moved_corners) : std::nullopt;
      if (!moved) return std::nullopt;
      jacobian.col(parameter) = (*moved - *centre) / step;
    }
    covariance += jacobian * sides[k].covariance * jacobian.transpose();
    outline.worst_rms_px = std::max(outline.worst_rms_px, sides[k].rms);
  }
  const auto to_image = [&frame](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(frame.u_of(p.x()), frame.v_of(p.y()));
  };
  outline.centre = to_image(*centre);
  outline.covariance = covariance * frame.scale * frame.scale;
  for (std::size_t k = 0; k < 4; ++k) outline.corners[k] = to_image((*corners)[k]);
  return outline;
}

}  // namespace markservo::target_locator
