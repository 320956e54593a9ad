#include "services/base-navigator/obstacles/free_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace markservo::base_navigator {
namespace {

using geometry::wrapped;

constexpr double kApproaching = 0.2;       // m nearer per m of path: less is driving past
constexpr double kFirstApproach_m = 0.03;  // of path, on which that is judged
constexpr double kSonarNoise_m = 0.01;     // nearer over the whole path: less is no approach

struct Standpoint {
  Eigen::Vector2d p_RS;
  double cosine;
  double sine;
  double length;

  Eigen::Vector2d seen_from_here(const Eigen::Vector2d& p_R) const {
    const Eigen::Vector2d d = p_R - p_RS;
    return {cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()};
  }
};

// m of path up to where the outline comes closer to a point that is too near already. Beside what a straight path does
// at once, a turning or curved one may sweep through the point only later.
double length_until_closer(const Outline& outline, double before, const Eigen::Vector2d& p_R,
                           const std::vector<Standpoint>& path) {
  const auto judged = std::find_if(path.begin(), path.end(),
                                   [](const Standpoint& standpoint) { return standpoint.length >= kFirstApproach_m; });
  const Standpoint& at = judged != path.end() ? *judged : path.back();
  const double after = distance_to_outline(outline, at.seen_from_here(p_R));
  if (before - after > kApproaching * at.length) return 0.0;
  // Half of what is left at most, lest it be used up bit by bit as the robot goes and looks again.
  const double least = before - std::min(kSonarNoise_m, 0.5 * before);
  double last = before;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double now = distance_to_outline(outline, path[i].seen_from_here(p_R));
    if (now < least) {
      const double part = (last - least) / (last - now);
      return path[i - 1].length + part * (path[i].length - path[i - 1].length);
    }
    last = now;
  }
  return path.back().length;
}

// m of path up to where the point is nearer than `clearance`; the path's whole length if it never is.
double length_until_near(const Outline& outline, double clearance, const Eigen::Vector2d& p_R,
                         const std::vector<Standpoint>& path) {
  double before = distance_to_outline(outline, p_R);
  if (before < clearance) return length_until_closer(outline, before, p_R, path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double now = distance_to_outline(outline, path[i].seen_from_here(p_R));
    if (now < clearance) {
      const double part = (before - clearance) / (before - now);
      return path[i - 1].length + part * (path[i].length - path[i - 1].length);
    }
    before = now;
  }
  return path.back().length;
}

}  // namespace

FreePath free_path(const Outline& outline, double clearance, const std::vector<SeenPoint>& points,
                   const std::vector<PathPose>& path) {
  FreePath free;
  if (path.size() < 2) return free;
  std::vector<Standpoint> standpoints;
  standpoints.reserve(path.size());
  for (const PathPose& pose : path) {
    standpoints.push_back(
        {pose.X_RS.position(), std::cos(pose.X_RS.heading), std::sin(pose.X_RS.heading), pose.length});
  }
  free.length = path.back().length;
  for (const SeenPoint& point : points) {
    const double length = length_until_near(outline, std::max(clearance, point.blind_range), point.p_R, standpoints);
    if (length >= free.length) continue;
    free.length = length;
    free.limited = true;
    free.distance = distance_to_outline(outline, point.p_R);
    free.bearing = std::atan2(point.p_R.y(), point.p_R.x());
  }
  return free;
}

std::string side_of(double bearing) {
  static const std::array<const char*, 8> kSides = {
      "ahead",  "ahead on the left",   "on the left",  "behind on the left",
      "behind", "behind on the right", "on the right", "ahead on the right"};
  const double eighths = std::round(wrapped(bearing) / (M_PI / 4.0));
  return kSides[static_cast<std::size_t>((static_cast<int>(eighths) + 8) % 8)];
}

}  // namespace markservo::base_navigator
