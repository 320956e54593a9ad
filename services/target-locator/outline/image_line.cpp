#include "services/target-locator/outline/image_line.hpp"

#include <cmath>
#include <cstddef>

namespace markservo::target_locator {

std::optional<Eigen::Vector2d> intersect(const ImageLine& a, const ImageLine& b) {
  const double determinant = a.n.x() * b.n.y() - a.n.y() * b.n.x();
  if (std::abs(determinant) < 1e-6) return std::nullopt;
  return Eigen::Vector2d((a.c * b.n.y() - b.c * a.n.y()) / determinant, (a.n.x() * b.c - b.n.x() * a.c) / determinant);
}

std::optional<Corners> corners_of(const Lines& lines) {
  Corners corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = intersect(lines[k], lines[(k + 1) % 4]);
    if (!corner) return std::nullopt;
    corners[k] = *corner;
  }
  return corners;
}

std::optional<Eigen::Vector2d> diagonals_meet(const Corners& corners) {
  const auto& c = corners;
  const Eigen::Vector2d a = c[2] - c[0];
  const Eigen::Vector2d b = c[3] - c[1];
  return intersect({{-a.y(), a.x()}, a.x() * c[0].y() - a.y() * c[0].x()},
                   {{-b.y(), b.x()}, b.x() * c[1].y() - b.y() * c[1].x()});
}

}  // namespace markservo::target_locator
