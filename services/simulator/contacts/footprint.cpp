#include "services/simulator/contacts/footprint.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

namespace markservo::simulator {
namespace {

using Corners = std::array<Eigen::Vector2d, 4>;

Corners corners_of(const Footprint& rectangle) {
  const Eigen::Rotation2Dd turn(rectangle.yaw);
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d sides(i == 0 || i == 3 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    corners[i] = rectangle.centre + turn * rectangle.half.cwiseProduct(sides);
  }
  return corners;
}

// True if an edge direction of `rectangle` separates it from `corners`.
bool separated_along(const Footprint& rectangle, const Corners& corners) {
  const Eigen::Rotation2Dd back(-rectangle.yaw);
  Eigen::Vector2d least = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d greatest = -least;
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector2d local = back * (corner - rectangle.centre);
    least = least.cwiseMin(local);
    greatest = greatest.cwiseMax(local);
  }
  return (least.array() > rectangle.half.array()).any() || (greatest.array() < -rectangle.half.array()).any();
}

double nearest_corner(const Footprint& rectangle, const Corners& corners) {
  const Eigen::Rotation2Dd back(-rectangle.yaw);
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : corners) {
    const Eigen::Vector2d beyond = (back * (corner - rectangle.centre)).cwiseAbs() - rectangle.half;
    nearest = std::min(nearest, beyond.cwiseMax(0.0).norm());
  }
  return nearest;
}

}  // namespace

double distance(const Footprint& a, const Footprint& b) {
  const Corners corners_a = corners_of(a);
  const Corners corners_b = corners_of(b);
  if (!separated_along(a, corners_b) && !separated_along(b, corners_a)) return 0.0;
  // Of two convex shapes apart, one's corner is among the nearest points.
  return std::min(nearest_corner(a, corners_b), nearest_corner(b, corners_a));
}

}  // namespace markservo::simulator
