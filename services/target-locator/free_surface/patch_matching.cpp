#include "services/target-locator/free_surface/patch_matching.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace markservo::target_locator {
namespace {

// A window of one image with its weights, ready to be correlated with windows of the other.
struct WeightedWindow {
  std::vector<float> weight;
  std::vector<float> weighted_grey;  // weight * (grey - weighted mean)
  double weight_sum = 0.0;
  double energy = 0.0;  // weighted sum of squares about the weighted mean
};

bool window_inside(const PlaneImage& image, int column, int row, int half) {
  return column - half >= 0 && column + half < image.width && row - half >= 0 && row + half < image.height;
}

WeightedWindow make_window(const PlaneImage& image, int column, int row, int half, double colour_sigma) {
  WeightedWindow window;
  const std::size_t side = 2 * static_cast<std::size_t>(half) + 1;
  window.weight.reserve(side * side);
  window.weighted_grey.reserve(side * side);
  const float middle = image.at(column, row);
  const double spread = static_cast<double>(half);
  double sum = 0.0;
  for (int y = -half; y <= half; ++y) {
    const float* line = image.row(row + y) + column;
    for (int x = -half; x <= half; ++x) {
      const double difference = static_cast<double>(line[x] - middle) / colour_sigma;
      const double distance = (x * x + y * y) / (spread * spread);
      // Half the weight never goes: a textured feature needs both its dark and its bright pixels.
      const double weight =
          std::exp(-0.5 * distance) * (0.25 + 0.75 * std::exp(-0.5 * std::min(difference * difference, 60.0)));
      window.weight.push_back(static_cast<float>(weight));
      window.weight_sum += weight;
      sum += weight * static_cast<double>(line[x]);
    }
  }
  const double mean = sum / window.weight_sum;
  std::size_t i = 0;
  for (int y = -half; y <= half; ++y) {
    const float* line = image.row(row + y) + column;
    for (int x = -half; x <= half; ++x, ++i) {
      const double grey = static_cast<double>(line[x]) - mean;
      const auto weight = static_cast<double>(window.weight[i]);
      window.weighted_grey.push_back(static_cast<float>(weight * grey));
      window.energy += weight * grey * grey;
    }
  }
  return window;
}

// Weighted correlation of the window with the other image's window at (column, row), -1..1.
double correlate(const WeightedWindow& window, const PlaneImage& other, int column, int row, int half) {
  float sum = 0.0F;
  float squares = 0.0F;
  float product = 0.0F;
  const int side = 2 * half + 1;
  const float* weight = window.weight.data();
  const float* grey = window.weighted_grey.data();
  const float reference = other.at(column, row);
  for (int y = -half; y <= half; ++y) {
    const float* line = other.row(row + y) + column - half;
    for (int x = 0; x < side; ++x) {
      const float value = line[x] - reference;
      sum += weight[x] * value;
      squares += weight[x] * value * value;
      product += grey[x] * value;
    }
    weight += side;
    grey += side;
  }
  const double energy =
      static_cast<double>(squares) - static_cast<double>(sum) * static_cast<double>(sum) / window.weight_sum;
  const double scale = window.energy * energy;
  return scale > 1e-6 ? static_cast<double>(product) / std::sqrt(scale) : -1.0;
}

struct Peak {
  int column = 0;
  double position = 0.0;  // column with the parabola's vertex
  double correlation = -1.0;
  double second = -1.0;  // the highest other local maximum
};

std::optional<Peak> best_peak(const WeightedWindow& window, const PlaneImage& other, int row, int from, int to,
                              int half) {
  from = std::max(from, half);
  to = std::min(to, other.width - 1 - half);
  if (from > to) return std::nullopt;
  std::vector<double> score(static_cast<std::size_t>(to - from + 1));
  for (int x = from; x <= to; ++x) score[static_cast<std::size_t>(x - from)] = correlate(window, other, x, row, half);
  const auto best = static_cast<std::size_t>(std::max_element(score.begin(), score.end()) - score.begin());
  Peak peak;
  peak.column = from + static_cast<int>(best);
  peak.position = peak.column;
  peak.correlation = score[best];
  for (std::size_t i = 0; i < score.size(); ++i) {
    const bool is_maximum = (i == 0 || score[i] >= score[i - 1]) && (i + 1 == score.size() || score[i] >= score[i + 1]);
    const bool apart = i + 2 < best || i > best + 2;
    if (is_maximum && apart) peak.second = std::max(peak.second, score[i]);
  }
  if (best > 0 && best + 1 < score.size()) {
    const double bend = score[best - 1] - 2.0 * score[best] + score[best + 1];
    if (bend < -1e-9) peak.position += std::clamp(0.5 * (score[best - 1] - score[best + 1]) / bend, -0.5, 0.5);
  }
  return peak;
}

}  // namespace

std::optional<double> search_match(const StereoPatch& patch, const Feature& feature,
                                   const SearchParameters& parameters) {
  const int half = parameters.half_window;
  const PlaneImage& left = patch.left;
  const PlaneImage& right = patch.right_rows;
  if (!window_inside(left, feature.column, feature.row, half) || right.height <= feature.row + half)
    return std::nullopt;
  const WeightedWindow window = make_window(left, feature.column, feature.row, half, parameters.colour_sigma);
  if (!(window.energy > window.weight_sum)) return std::nullopt;

  const double u = patch.left_frame.u_of(feature.column);
  const auto limit = [](double column, int width) {
    return static_cast<int>(std::clamp(column, -1.0, static_cast<double>(width)));
  };
  const int from = limit(std::ceil(patch.right_frame.column_of(u - parameters.disparity_max)), right.width);
  const int to = limit(std::floor(patch.right_frame.column_of(u - parameters.disparity_min)), right.width);
  const auto peak = best_peak(window, right, feature.row, from, to, half);
  if (!peak || peak->correlation < parameters.min_correlation) return std::nullopt;
  if (peak->second > peak->correlation - parameters.uniqueness) return std::nullopt;

  const WeightedWindow back = make_window(right, peak->column, feature.row, half, parameters.colour_sigma);
  const double u_right = patch.right_frame.u_of(peak->column);
  const int back_from = limit(std::ceil(patch.left_frame.column_of(u_right + parameters.disparity_min)), left.width);
  const int back_to = limit(std::floor(patch.left_frame.column_of(u_right + parameters.disparity_max)), left.width);
  const auto mirrored = best_peak(back, left, feature.row, back_from, back_to, half);
  if (!mirrored || std::abs(mirrored->column - feature.column) > parameters.max_disagreement) return std::nullopt;
  return u - patch.right_frame.u_of(peak->position);
}

}  // namespace markservo::target_locator
