#include "services/target-locator/features/features.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "services/target-locator/features/tensor_kernel.hpp"

namespace markservo::target_locator {
namespace {

// Ties are broken by position, so that the choice is the same everywhere.
bool stronger(const Feature& a, const Feature& b) {
  if (a.weight != b.weight) return a.weight > b.weight;
  if (a.row != b.row) return a.row < b.row;
  return a.column < b.column;
}

// Brings the `count` strongest from `first` on to the front of what is there.
void strongest_first(std::vector<Feature>& features, std::size_t first, std::size_t count) {
  if (first + count >= features.size()) return;
  const auto begin = features.begin() + static_cast<std::ptrdiff_t>(first);
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(count), features.end(), stronger);
}

// The strongest of every cell of a grid to the front; their number.
std::size_t best_of_cells_first(std::vector<Feature>& features, double cell, int width, int height) {
  const int across = static_cast<int>(width / cell) + 1;
  const int down = static_cast<int>(height / cell) + 1;
  constexpr int kNone = -1;
  std::vector<int> best(static_cast<std::size_t>(across) * static_cast<std::size_t>(down), kNone);
  const auto cell_of = [&](const Feature& feature) {
    return static_cast<std::size_t>(feature.row / cell) * static_cast<std::size_t>(across) +
           static_cast<std::size_t>(feature.column / cell);
  };
  for (std::size_t i = 0; i < features.size(); ++i) {
    int& chosen = best[cell_of(features[i])];
    if (chosen == kNone || stronger(features[i], features[static_cast<std::size_t>(chosen)])) {
      chosen = static_cast<int>(i);
    }
  }
  std::sort(best.begin(), best.end());
  std::size_t count = 0;
  for (const int i : best) {
    // In rising order, so that what is moved has not been chosen.
    if (i != kNone) std::swap(features[count++], features[static_cast<std::size_t>(i)]);
  }
  return count;
}

}  // namespace

void find_features(const CornerMeasures& measures, const Mask& mask, const FeatureParameters& parameters,
                   std::vector<Feature>& features) {
  features.clear();
  std::vector<std::uint64_t> maxima(static_cast<std::size_t>(mask.words_per_row()));
  for (int y = 0; y < mask.height(); ++y) {
    if (mask.surely_empty(y)) continue;
    find_maxima(measures, y, parameters.min_weight, parameters.min_roundness, mask.row(y), maxima.data());
    for (std::size_t i = 0; i < maxima.size(); ++i) {
      for (std::uint64_t bits = maxima[i]; bits != 0; bits &= bits - 1) {
        const int x = static_cast<int>(i) * Mask::kWordBits + __builtin_ctzll(bits);
        features.push_back({x, y, measures.weight.at(x, y)});
      }
    }
  }
  const auto wanted = static_cast<std::size_t>(std::max(parameters.max_features, 0));
  if (features.size() > wanted && wanted > 0) {
    const auto area = static_cast<double>(mask.count());
    const double cell = std::max(2.0, std::sqrt(area / static_cast<double>(wanted)));
    const std::size_t spread = best_of_cells_first(features, cell, mask.width(), mask.height());
    if (spread < wanted) {
      strongest_first(features, spread, wanted - spread);
    } else {
      features.resize(spread);
      strongest_first(features, 0, wanted);
    }
  }
  features.resize(std::min(features.size(), wanted));
  std::sort(features.begin(), features.end(),
            [](const Feature& a, const Feature& b) { return a.row != b.row ? a.row < b.row : a.column < b.column; });
}

std::vector<Feature> find_features(const CornerMeasures& measures, const Mask& mask,
                                   const FeatureParameters& parameters) {
  std::vector<Feature> features;
  find_features(measures, mask, parameters, features);
  return features;
}

}  // namespace markservo::target_locator
