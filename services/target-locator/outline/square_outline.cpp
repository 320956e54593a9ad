#include "services/target-locator/outline/square_outline.hpp"

#include <algorithm>
#include <cstddef>

#include "services/target-locator/outline/moment_square.hpp"

namespace markservo::target_locator {
namespace {

using Sides = std::array<SquareSide, 4>;

Lines lines_of(const Sides& sides) {
  Lines lines;
  for (std::size_t k = 0; k < 4; ++k) lines[k] = line_of(sides[k]);
  return lines;
}

// Nothing when a side is short, hidden, or reaches out of the patch.
std::optional<Sides> fit_sides(const PlaneImage& contrast, const Mask& mask, const OutlineParameters& parameters) {
  const auto start = lines_from_moments(mask, parameters.min_squareness);
  if (!start) return std::nullopt;
  const auto rough = corners_of(*start);
  if (!rough) return std::nullopt;
  Mask columns;
  imaging::transpose(mask, columns);
  EdgePoints points;
  points.reserve(static_cast<std::size_t>(std::max(mask.width(), mask.height())));
  Sides sides;
  for (std::size_t k = 0; k < 4; ++k) {
    constexpr double kShortest = 5.0;  // patch px
    SquareSide& side = sides[k];
    side = side_of((*start)[k], (*rough)[(k + 3) % 4], (*rough)[k], parameters.side.corner_share);
    if (side.to - side.from < kShortest) return std::nullopt;
    if (!fit_to_mask(side.upright ? mask : columns, parameters.side, points, side)) return std::nullopt;
    if (!fit_to_contrast(contrast, parameters.side, points, side)) return std::nullopt;
  }
  return sides;
}

// How the centre moves with a side's (p, q).
std::optional<Eigen::Matrix2d> centre_jacobian(const Sides& sides, std::size_t which, const Eigen::Vector2d& centre) {
  constexpr double kStep = 1e-3;
  const SquareSide& side = sides[which];
  Eigen::Matrix2d jacobian;
  for (int parameter = 0; parameter < 2; ++parameter) {
    const double step = parameter == 0 ? kStep : kStep / std::max(1.0, side.to - side.from);
    auto lines = lines_of(sides);
    lines[which] = line_of(side, side.p + (parameter == 0 ? step : 0.0), side.q + (parameter == 1 ? step : 0.0));
    const auto moved_corners = corners_of(lines);
    const auto moved = moved_corners ? diagonals_meet(*moved_corners) : std::nullopt;
    if (!moved) return std::nullopt;
    jacobian.col(parameter) = (*moved - centre) / step;
  }
  return jacobian;
}

}  // namespace

std::optional<SquareOutline> fit_square(const PlaneImage& contrast, const Mask& mask, const PatchFrame& frame,
                                        const OutlineParameters& parameters) {
  const auto sides = fit_sides(contrast, mask, parameters);
  if (!sides) return std::nullopt;
  const auto corners = corners_of(lines_of(*sides));
  if (!corners) return std::nullopt;
  const auto centre = diagonals_meet(*corners);
  if (!centre || !centre->allFinite()) return std::nullopt;

  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() * parameters.centre_floor_px * parameters.centre_floor_px;
  SquareOutline outline;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto jacobian = centre_jacobian(*sides, k, *centre);
    if (!jacobian) return std::nullopt;
    covariance += *jacobian * (*sides)[k].covariance * jacobian->transpose();
    outline.worst_rms_px = std::max(outline.worst_rms_px, (*sides)[k].rms);
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
