#include "services/target-locator/hidden/outermost_edge.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::target_locator {
namespace {

constexpr double kNowhere = -1e9;  // m

// How far out the outline reaches, pixel by pixel along the edge.
struct Profile {
  double limit = 0.0;         // m inwards, of the outermost point that is no stray
  std::vector<double> reach;  // m outwards; kNowhere where the outline is not; empty for an outline beyond all measure
};

Profile profile_of(const Points& points, const Eigen::Vector2d& outwards, double pixel) {
  const Eigen::Vector2d sideways(-outwards.y(), outwards.x());
  std::vector<double> inwards;
  double first = 1e9;
  double last = -1e9;
  for (const auto& point : points) {
    inwards.push_back(-outwards.dot(point));
    first = std::min(first, sideways.dot(point));
    last = std::max(last, sideways.dot(point));
  }
  Profile profile;
  profile.limit = nth_value(inwards, kStrays);
  constexpr double kLongest = 4096.0;  // pixels; no patch is as long
  if (!((last - first) / pixel <= kLongest)) return profile;
  profile.reach.assign(static_cast<std::size_t>((last - first) / pixel) + 1, kNowhere);
  for (const auto& point : points) {
    double& here = profile.reach[static_cast<std::size_t>((sideways.dot(point) - first) / pixel)];
    here = std::max(here, outwards.dot(point));
  }
  return profile;
}

// Pixels [begin, end) along the edge.
struct Stretch {
  std::size_t begin = 0;
  std::size_t end = 0;

  std::size_t size() const { return end - begin; }
};

// The longest stretch within `band` of the outermost point.
Stretch longest_stretch(const Profile& profile, double band) {
  const std::size_t count = profile.reach.size();
  Stretch best;
  for (std::size_t begin = 0; begin < count;) {
    std::size_t end = begin;
    while (end < count && profile.reach[end] >= -profile.limit - band) ++end;
    if (end - begin > best.size()) best = {begin, end};
    begin = end + 1;
  }
  return best;
}

}  // namespace

OutermostEdge outermost_edge(const Points& points, const Eigen::Vector2d& outwards, double pixel) {
  const Profile profile = profile_of(points, outwards, pixel);
  if (profile.reach.empty()) return {};
  constexpr double kBand = 2.5;  // pixels
  const Stretch straight = longest_stretch(profile, kBand * pixel);
  OutermostEdge edge;
  edge.out = -profile.limit;
  const double n = static_cast<double>(straight.size());
  edge.length = n * pixel;
  if (n < 3.0) return edge;
  // A line by least squares.
  double mean = 0.0;
  for (std::size_t i = straight.begin; i < straight.end; ++i) mean += profile.reach[i] / n;
  const double middle = 0.5 * static_cast<double>(straight.begin + straight.end - 1);
  double cross = 0.0;
  double squares = 0.0;
  for (std::size_t i = straight.begin; i < straight.end; ++i) {
    const double t = (static_cast<double>(i) - middle) * pixel;
    cross += t * (profile.reach[i] - mean);
    squares += t * t;
  }
  edge.slope = cross / squares;
  for (std::size_t i = straight.begin; i < straight.end; ++i) {
    const double off = profile.reach[i] - mean - edge.slope * (static_cast<double>(i) - middle) * pixel;
    edge.rms += off * off / n;
  }
  edge.rms = std::sqrt(edge.rms);
  edge.slope_sigma = std::max(edge.rms, 0.3 * pixel) / std::sqrt(squares);
  edge.out = mean;
  return edge;
}

double nth_value(std::vector<double> values, std::size_t n) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), values.end());
  return values[n];
}

}  // namespace markservo::target_locator
