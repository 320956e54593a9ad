#include "services/target-locator/features.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace markservo::target_locator {
namespace {

// A candidate with ties broken by position, so that the choice is the same everywhere.
bool stronger(const Feature& a, const Feature& b) {
  if (a.weight != b.weight) return a.weight > b.weight;
  if (a.row != b.row) return a.row < b.row;
  return a.column < b.column;
}

bool is_local_maximum(const PlaneImage& weight, int x, int y) {
  constexpr int kAround[][2] = {{-1, 0}, {1, 0},  {-1, -1}, {0, -1},
                                {1, -1}, {-1, 1}, {0, 1},   {1, 1}};  // near in memory first
  const float value = weight.at(x, y);
  for (const auto& [dx, dy] : kAround) {
    const int nx = x + dx;
    const int ny = y + dy;
    if (nx < 0 || ny < 0 || nx >= weight.width || ny >= weight.height) continue;
    const float other = weight.at(nx, ny);
    // On a plateau the first pixel in reading order stands for it.
    const bool before = dy < 0 || (dy == 0 && dx < 0);
    if (other > value || (before && other == value)) return false;
  }
  return true;
}

}  // namespace

std::vector<Feature> find_features(const CornerMeasures& measures, const Mask& mask,
                                   const FeatureParameters& parameters) {
  std::vector<Feature> candidates;
  std::size_t area = 0;
  for (int y = 0; y < mask.height; ++y) {
    const unsigned char* inside = mask.row(y);
    const float* weight = measures.weight.row(y);
    const float* roundness = measures.roundness.row(y);
    for (int x = 0; x < mask.width; ++x) {
      if (inside[x] == 0) continue;
      ++area;
      if (!(weight[x] >= parameters.min_weight) || !(roundness[x] >= parameters.min_roundness)) continue;
      if (is_local_maximum(measures.weight, x, y)) candidates.push_back({x, y, weight[x]});
    }
  }
  const auto wanted = static_cast<std::size_t>(std::max(parameters.max_features, 0));
  std::sort(candidates.begin(), candidates.end(), stronger);
  if (candidates.size() > wanted && wanted > 0) {
    const double cell = std::max(2.0, std::sqrt(static_cast<double>(area) / static_cast<double>(wanted)));
    const int across = static_cast<int>(mask.width / cell) + 1;
    const int down = static_cast<int>(mask.height / cell) + 1;
    Mask taken(across, down);
    std::vector<Feature> first_of_cell;
    std::vector<Feature> rest;
    for (const Feature& feature : candidates) {
      unsigned char& cell_taken =
          taken.at(static_cast<int>(feature.column / cell), static_cast<int>(feature.row / cell));
      (cell_taken == 0 ? first_of_cell : rest).push_back(feature);
      cell_taken = 1;
    }
    first_of_cell.insert(first_of_cell.end(), rest.begin(), rest.end());
    candidates = std::move(first_of_cell);
  }
  candidates.resize(std::min(candidates.size(), wanted));
  std::sort(candidates.begin(), candidates.end(),
            [](const Feature& a, const Feature& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
  return candidates;
}

}  // namespace markservo::target_locator
