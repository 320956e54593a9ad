#include "services/target-locator/matching/refinement.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "services/target-locator/matching/window_kernel.hpp"

namespace markservo::target_locator {
namespace {

Eigen::Vector3d first(const WindowMoments& m) {
  return Eigen::Vector3f(m[0], m[1], m[2]).cast<double>();
}

// Of (1, du, dv) times itself.
Eigen::Matrix3d second(const WindowMoments& m) {
  Eigen::Matrix3f matrix;
  matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  return matrix.cast<double>();
}

// The left window and what follows from it alone.
struct Window {
  WindowFrame frame;
  float about = 0.0F;   // grey that is taken off both views
  double n = 0.0;       // pixels
  double mean = 0.0;    // of the greys less `about`
  double energy = 0.0;  // sum of squared greys about the mean
  // Of (1, du, dv), weighted by the gradients.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Vector3d gradient_grey = Eigen::Vector3d::Zero();  // greys about the mean
  Eigen::Matrix3d newton = Eigen::Matrix3d::Zero();         // with the plain difference as right factor: the true slope
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();    // with the left factor again: what noise does
};

Window make_window(const StereoPatch& patch, const Feature& feature, int half, const Mask* support) {
  Window window;
  const PlaneImage& left = patch.left;
  // Central differences need a neighbour.
  const int x0 = std::max(1, feature.column - half);
  const int x1 = std::min(left.width - 2, feature.column + half);
  const int y0 = std::max(0, feature.row - half);
  const int y1 = std::min(left.height - 1, feature.row + half);
  if (x1 < x0 || y1 < y0) return window;
  const double scale = patch.left_frame.scale;
  WindowFrame& frame = window.frame;
  frame.column = x0;
  frame.row = y0;
  frame.height = y1 - y0 + 1;
  frame.du = static_cast<float>((x0 - feature.column) * scale);
  frame.dv = static_cast<float>((y0 - feature.row) * scale);
  frame.scale = static_cast<float>(scale);
  const std::uint64_t whole = imaging::low_bits(x1 - x0 + 1);
  for (int j = 0; j < frame.height; ++j) {
    const std::uint64_t used = support == nullptr ? whole : support->window(x0, y0 + j) & whole;
    frame.used[static_cast<std::size_t>(j)] = static_cast<std::uint16_t>(used);
  }
  window.about = left.at(feature.column, feature.row);
  const WindowSums sums = sum_window(left, patch.left_gradients.column, frame, window.about);
  window.n = static_cast<double>(sums.n);
  if (!(window.n > 0.0)) return window;
  window.mean = static_cast<double>(sums.grey) / window.n;
  window.energy = static_cast<double>(sums.grey_squares) - window.n * window.mean * window.mean;
  window.gradient = first(sums.gradient);
  window.gradient_grey = first(sums.gradient_grey) - window.mean * window.gradient;
  window.newton = second(sums.newton);
  window.information = second(sums.information);
  return window;
}

// The right window under a local disparity, compared with the left one.
struct Comparison {
  double gain = 0.0;                                   // right contrast over left
  double energy = 0.0;                                 // right greys about their mean, squared and summed
  double product = 0.0;                                // of left and right greys about their means, summed
  Eigen::Vector3d mismatch = Eigen::Vector3d::Zero();  // gradient-weighted right minus gain times left
};

// Nothing when the window's middle leaves the right patch.
std::optional<Comparison> compare(const Window& window, const StereoPatch& patch, double u,
                                  const LocalDisparity& local) {
  const double base = patch.right_frame.column_of(u - local.disparity);
  if (!(base >= 2.0) || !(base <= patch.right_rows.width - 3.0)) return std::nullopt;
  RightColumns columns;
  columns.base = static_cast<float>(base);
  columns.per_u = static_cast<float>((1.0 - local.along_u) / patch.right_frame.scale);
  columns.per_v = static_cast<float>(-local.along_v / patch.right_frame.scale);
  const ComparisonSums sums =
      compare_window(patch.left, patch.left_gradients.column, patch.right_rows, window.frame, columns, window.about);
  const double mean = static_cast<double>(sums.right) / window.n;
  Comparison result;
  result.energy = static_cast<double>(sums.squares) - window.n * mean * mean;
  result.product = static_cast<double>(sums.product) - window.n * mean * window.mean;
  result.gain = result.product / window.energy;
  result.mismatch = first(sums.gradient_right) - mean * window.gradient - result.gain * window.gradient_grey;
  return result;
}

// The inverse for the disparity alone, or for its slopes as well; the rest is 0.
Eigen::Matrix3d step_matrix(const Window& window, bool solve_slopes) {
  if (solve_slopes) return window.newton.inverse();
  Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
  step(0, 0) = 1.0 / window.newton(0, 0);
  return step;
}

}  // namespace

std::optional<RefinedMatch> refine_match(const StereoPatch& patch, const Feature& feature, const LocalDisparity& start,
                                         const Mask* support, const RefinementParameters& parameters) {
  constexpr double kSteepest = 1.5;     // px per px
  constexpr double kLargestGain = 5.0;  // between two cameras that see the same
  const int half = std::clamp(parameters.half_window, 1, WindowFrame::kLargestHalf);
  const int side = 2 * half + 1;
  const Window window = make_window(patch, feature, half, support);
  const double n = window.n;
  // A quarter of the window and a few more, with at least one grey level of contrast.
  if (n < 0.25 * side * side + 6.0 || !(window.energy > n) || !(window.newton(0, 0) > 1e-6)) return std::nullopt;
  const Eigen::Matrix3d step = step_matrix(window, parameters.solve_slopes);
  if (!step.allFinite()) return std::nullopt;

  const double u = patch.left_frame.u_of(feature.column);
  LocalDisparity local = start;
  std::optional<Comparison> seen;
  bool settled = false;
  for (int k = 0; k < parameters.max_iterations && !settled; ++k) {
    seen = compare(window, patch, u, local);
    if (!seen || !(seen->gain > 1.0 / kLargestGain) || !(seen->gain < kLargestGain)) return std::nullopt;
    const Eigen::Vector3d change = step * seen->mismatch / seen->gain;
    local.disparity += change[0];
    local.along_u += change[1];
    local.along_v += change[2];
    if (!(std::abs(local.disparity - start.disparity) <= parameters.max_change_px)) return std::nullopt;
    if (!(std::abs(local.along_u) < kSteepest) || !(std::abs(local.along_v) < kSteepest)) return std::nullopt;
    settled = std::abs(change[0]) < parameters.settled_px;
  }
  // What was seen a settled step before will do.
  if (!settled) seen = compare(window, patch, u, local);
  if (!seen || !(seen->energy > 0.0)) return std::nullopt;
  RefinedMatch match;
  match.local = local;
  match.correlation = seen->product / std::sqrt(window.energy * seen->energy);
  if (!(match.correlation >= parameters.min_correlation)) return std::nullopt;
  const double residual = std::max(0.0, seen->energy - seen->product * seen->gain);
  const double unknowns = parameters.solve_slopes ? 5.0 : 3.0;
  const double variance = residual / std::max(1.0, n - unknowns) / (seen->gain * seen->gain);
  const Eigen::Matrix3d covariance = variance * step * window.information * step.transpose();
  match.sigma = std::sqrt(std::max(0.0, covariance(0, 0)));
  return match;
}

}  // namespace markservo::target_locator
