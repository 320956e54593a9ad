#include "services/camera-check/pair/pair_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace markservo::camera_check {
namespace {

constexpr std::size_t kLeastOfThird = 8;  // points: a median of fewer is a matter of luck
constexpr double kBehind_px = -1.0;       // what is far has a disparity of about 0, on either side of it
constexpr double kSame_px = 0.05;         // two cameras at one place do not exist

std::optional<double> median(std::vector<double> values, std::size_t least) {
  if (values.size() < std::max<std::size_t>(least, 1)) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

RowOffsets row_offsets(std::vector<CornerMatch> matches) {
  // Whichever camera is rolled: between the two columns at which they show it.
  std::sort(matches.begin(), matches.end(), [](const CornerMatch& one, const CornerMatch& other) {
    return one.left.x + one.right.x < other.left.x + other.right.x;
  });
  std::vector<double> offsets;
  for (const CornerMatch& match : matches) offsets.push_back(match.right.y - match.left.y);
  const auto third = static_cast<std::ptrdiff_t>(offsets.size() / 3);
  RowOffsets rows;
  rows.left_px = median({offsets.begin(), offsets.begin() + third}, kLeastOfThird);
  rows.right_px = median({offsets.end() - third, offsets.end()}, kLeastOfThird);
  rows.middle_px = *median(std::move(offsets), 1);
  return rows;
}

}  // namespace

double RowOffsets::worst_px() const {
  double worst = middle_px;
  for (const auto& each : {left_px, right_px}) {
    if (each && std::abs(*each) > std::abs(worst)) worst = *each;
  }
  return worst;
}

PairGeometry geometry_of(const PairMatches& found, double infinity_px) {
  PairGeometry geometry;
  geometry.num_corners = found.num_corners;
  geometry.num_matches = static_cast<int>(found.matches.size());
  if (found.matches.empty()) return geometry;
  int behind = 0;
  std::vector<double> distances;
  for (const CornerMatch& match : found.matches) {
    if (match.left.x - match.right.x - infinity_px < kBehind_px) ++behind;
    distances.push_back(std::hypot(match.left.x - match.right.x, match.left.y - match.right.y));
  }
  geometry.behind_share = static_cast<double>(behind) / static_cast<double>(found.matches.size());
  geometry.is_one_picture = *median(distances, 1) < kSame_px;
  geometry.rows = row_offsets(found.matches);
  return geometry;
}

}  // namespace markservo::camera_check
