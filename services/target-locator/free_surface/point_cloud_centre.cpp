#include "services/target-locator/free_surface/point_cloud_centre.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::target_locator {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<CloudCentre> centre_of_points(const std::vector<Match>& matches, const geometry::StereoCamera& camera) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> depths;
  for (const Match& match : matches) {
    const auto p_C = geometry::triangulate(camera, {match.u_left, match.v_left, match.u_right});
    if (!p_C) continue;
    points.push_back(*p_C);
    depths.push_back(p_C->y());
  }
  if (points.empty()) return std::nullopt;
  const double middle = median(depths);
  std::vector<double> apart;
  apart.reserve(depths.size());
  for (const double depth : depths) apart.push_back(std::abs(depth - middle));
  const double limit = std::max(3.0 * 1.4826 * median(apart), 1e-6);

  CloudCentre centre;
  std::vector<Eigen::Vector3d> kept;
  for (const auto& point : points) {
    if (std::abs(point.y() - middle) > limit) continue;
    kept.push_back(point);
    centre.p_C += point;
  }
  const auto n = static_cast<double>(kept.size());
  centre.num_points = static_cast<int>(kept.size());
  centre.p_C /= n;
  for (const auto& point : kept) {
    const Eigen::Vector3d off = point - centre.p_C;
    centre.covariance += off * off.transpose() / (n * std::max(1.0, n - 1.0));
  }
  return centre;
}

}  // namespace markservo::target_locator
