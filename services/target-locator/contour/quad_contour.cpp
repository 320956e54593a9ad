#include "services/target-locator/contour/quad_contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace markservo::target_locator {
namespace {

constexpr double kShortest_px = 5.0;  // of a side, below which its two ends' blur meets

// Twice the signed area.
double doubled_area(const Corners& corners) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& a = corners[k];
    const Eigen::Vector2d& b = corners[(k + 1) % 4];
    sum += a.x() * b.y() - b.x() * a.y();
  }
  return sum;
}

}  // namespace

std::optional<QuadContour> QuadContour::from_lines(const Lines& lines) {
  const auto corners = corners_of(lines);
  if (!corners) return std::nullopt;
  QuadContour contour;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& from = (*corners)[(k + 3) % 4];
    const Eigen::Vector2d& to = (*corners)[k];
    Side& side = contour.sides_[k];
    side.length = (to - from).norm();
    if (!(side.length >= kShortest_px)) return std::nullopt;
    side.middle = 0.5 * (from + to);
    side.outward = lines[k].n.normalized();
    side.along = (to - from) / side.length;
  }
  return contour.is_sane() ? std::make_optional(contour) : std::nullopt;
}

Coverage QuadContour::at(double x, double y, double blur) const {
  const Eigen::Vector2d here(x, y);
  std::array<double, 4> along;
  std::array<double, 4> distance;
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Side& side = sides_[k];
    const Eigen::Vector2d off = here - side.middle;
    const double out = parameters_[static_cast<int>(2 * k)];
    const double turn = parameters_[static_cast<int>(2 * k + 1)];
    along[k] = side.along.dot(off);
    distance[k] = (out + turn * along[k] - side.outward.dot(off)) / std::sqrt(1.0 + turn * turn);
    if (distance[k] < distance[nearest]) nearest = k;
  }
  Coverage coverage;
  coverage.distance = distance[nearest];
  const double part = std::clamp(along[nearest] / sides_[nearest].length + 0.5, 0.0, 1.0);
  coverage.around = 0.25 * (static_cast<double>(nearest) + part);
  const auto edge = [&](std::size_t k) {
    return BlurredEdge(distance[k], blur, sides_[k].outward.x(), sides_[k].outward.y());
  };
  const std::array<BlurredEdge, 4> edges{edge(0), edge(1), edge(2), edge(3)};
  coverage.by_distance = edges[nearest].by_distance;
  coverage.share = edges[0].share * edges[1].share * edges[2].share * edges[3].share;
  for (std::size_t k = 0; k < 4; ++k) {
    if (edges[k].by_distance <= 0.0) continue;
    const double others = edges[(k + 1) % 4].share * edges[(k + 2) % 4].share * edges[(k + 3) % 4].share;
    coverage.by_blur += others * edges[k].by_blur;
    coverage.by_shape[2 * k] = others * edges[k].by_distance;
    coverage.by_shape[2 * k + 1] = coverage.by_shape[2 * k] * along[k];
  }
  return coverage;
}

double QuadContour::perimeter() const {
  double sum = 0.0;
  for (const Side& side : sides_) sum += side.length;
  return sum;
}

bool QuadContour::is_sane() const {
  const auto at = corners();
  if (!at || !parameters_.allFinite()) return false;
  const double sign = doubled_area(*at) > 0.0 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d a = (*at)[(k + 1) % 4] - (*at)[k];
    const Eigen::Vector2d b = (*at)[(k + 2) % 4] - (*at)[(k + 1) % 4];
    if (!(a.norm() >= kShortest_px) || !(sign * (a.x() * b.y() - a.y() * b.x()) > 0.0)) return false;
  }
  return true;
}

std::optional<Corners> QuadContour::corners() const {
  Lines lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const Side& side = sides_[k];
    const double turn = parameters_[static_cast<int>(2 * k + 1)];
    const Eigen::Vector2d normal = side.outward - turn * side.along;
    lines[k] = {normal, normal.dot(side.middle) + parameters_[static_cast<int>(2 * k)]};
  }
  return corners_of(lines);
}

}  // namespace markservo::target_locator
