#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace markservo::geometry {

// Points on a plane, quick to find by place.
class PointGrid {
 public:
  // `cell` (m, above 0) is the edge of the square cells that near() looks through: about the radius that is asked for.
  explicit PointGrid(double cell) : cell_(cell) {}

  // Their numbers count up from 0.
  void add(const Eigen::Vector2d& point);

  std::size_t size() const { return points_.size(); }
  const Eigen::Vector2d& operator[](int number) const { return points_[static_cast<std::size_t>(number)]; }  // m

  // The numbers of the points within `radius` (m, 0 or more) of `p`, rising, into `numbers`.
  void near(const Eigen::Vector2d& p, double radius, std::vector<int>& numbers) const;

 private:
  int index(double coordinate) const;

  double cell_;
  std::vector<Eigen::Vector2d> points_;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

}  // namespace markservo::geometry
