#include "services/target-locator/paper/paper_matching.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markservo::target_locator {

std::vector<Match> match_as_in_the_paper(const std::vector<Feature>& features, const Gradients& left,
                                         const Gradients& right, const View& left_view, const View& right_view,
                                         const PaperParameters& parameters) {
  std::vector<Match> matches;
  const PatchFrame& left_frame = left_view.patch.frame;
  const PatchFrame& right_frame = right_view.patch.frame;
  const double half_u = 0.5 * parameters.window * right_view.width;
  const double half_v = 0.5 * parameters.window * right_view.height;
  for (const Feature& feature : features) {
    const double u = left_frame.u_of(feature.column);
    const double v = left_frame.v_of(feature.row);
    const double expected_u = u - left_view.centre_u() + right_view.centre_u();
    const double expected_v = v - left_view.centre_v() + right_view.centre_v();
    const auto column = [&](double at) {
      return static_cast<int>(std::lround(std::clamp(right_frame.column_of(at), 0.0, right.column.width - 1.0)));
    };
    const auto row = [&](double at) {
      return static_cast<int>(std::lround(std::clamp(right_frame.row_of(at), 0.0, right.column.height - 1.0)));
    };
    const float gc = left.column.at(feature.column, feature.row);
    const float gr = left.row.at(feature.column, feature.row);
    float best = std::numeric_limits<float>::infinity();
    int best_x = 0;
    int best_y = 0;
    for (int y = row(expected_v - half_v); y <= row(expected_v + half_v); ++y) {
      for (int x = column(expected_u - half_u); x <= column(expected_u + half_u); ++x) {
        const float dc = gc - right.column.at(x, y);
        const float dr = gr - right.row.at(x, y);
        const float difference = dc * dc + dr * dr;
        if (difference < best) {
          best = difference;
          best_x = x;
          best_y = y;
        }
      }
    }
    if (!std::isfinite(best)) continue;
    matches.push_back({u, v, right_frame.u_of(best_x), right_frame.v_of(best_y),
                       parameters.alpha * std::sqrt(static_cast<double>(best))});
  }
  return matches;
}

PaperPosition position_as_in_the_paper(const std::vector<Match>& matches, const geometry::StereoCamera& camera) {
  std::vector<Eigen::Vector3d> points;
  PaperPosition position;
  for (const Match& match : matches) {
    const auto p_C = geometry::triangulate(camera, {match.u_left, match.v_left, match.u_right});
    if (!p_C) continue;
    points.push_back(*p_C);
    position.p_C += *p_C;
  }
  position.num_points = static_cast<int>(points.size());
  if (points.empty()) return position;
  const auto n = static_cast<double>(points.size());
  position.p_C /= n;
  for (const auto& point : points) {
    const Eigen::Vector3d apart = point - position.p_C;
    position.covariance += apart * apart.transpose() / (n * std::max(1.0, n - 1.0));
  }
  return position;
}

}  // namespace markservo::target_locator
