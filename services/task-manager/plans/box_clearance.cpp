#include "services/task-manager/plans/box_clearance.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace markservo::task_manager {

double box_clearance(const Box& a, const Box& b) {
  const Eigen::Matrix3d axes_a = a.X_CB.linear();
  const Eigen::Matrix3d axes_b = b.X_CB.linear();
  std::vector<Eigen::Vector3d> directions;
  for (int i = 0; i < 3; ++i) {
    directions.emplace_back(axes_a.col(i));
    directions.emplace_back(axes_b.col(i));
    for (int j = 0; j < 3; ++j) directions.emplace_back(axes_a.col(i).cross(axes_b.col(j)));
  }
  const Eigen::Vector3d between = b.X_CB.translation() - a.X_CB.translation();
  double widest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& direction : directions) {
    constexpr double kParallel = 1e-6;  // edges that are parallel span no axis
    const double length = direction.norm();
    if (length < kParallel) continue;
    const Eigen::Vector3d axis = direction / length;
    const double reach_a = (axes_a.transpose() * axis).cwiseAbs().dot(a.half_size);
    const double reach_b = (axes_b.transpose() * axis).cwiseAbs().dot(b.half_size);
    widest = std::max(widest, std::abs(axis.dot(between)) - reach_a - reach_b);
  }
  return widest;
}

}  // namespace markservo::task_manager
