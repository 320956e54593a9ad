#include "common/geometry/point_grid.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::geometry {
namespace {

std::int64_t key(int column, int row) {
  return static_cast<std::int64_t>((static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) |
                                   static_cast<std::uint32_t>(row));
}

}  // namespace

int PointGrid::index(double coordinate) const {
  // Who is far off all points asks for cells that hold nothing.
  constexpr double kFarthest = 1e9;
  return static_cast<int>(std::floor(std::clamp(coordinate / cell_, -kFarthest, kFarthest)));
}

void PointGrid::add(const Eigen::Vector2d& point) {
  cells_[key(index(point.x()), index(point.y()))].push_back(static_cast<int>(points_.size()));
  points_.push_back(point);
}

void PointGrid::near(const Eigen::Vector2d& p, double radius, std::vector<int>& numbers) const {
  numbers.clear();
  const auto take = [&](int number) {
    if (((*this)[number] - p).squaredNorm() <= radius * radius) numbers.push_back(number);
  };
  const int first_column = index(p.x() - radius);
  const int first_row = index(p.y() - radius);
  const int last_column = index(p.x() + radius);
  const int last_row = index(p.y() + radius);
  // Who does not know where it is asks for more cells than there are points.
  const double cells = (1.0 + last_column - first_column) * (1.0 + last_row - first_row);
  if (cells > static_cast<double>(size())) {
    for (int number = 0; number < static_cast<int>(size()); ++number) take(number);
    return;
  }
  for (int column = first_column; column <= last_column; ++column) {
    for (int row = first_row; row <= last_row; ++row) {
      const auto cell = cells_.find(key(column, row));
      if (cell == cells_.end()) continue;
      for (const int number : cell->second) take(number);
    }
  }
  std::sort(numbers.begin(), numbers.end());
}

}  // namespace markservo::geometry
