#include "services/target-locator/refinement.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "services/target-locator/epipolar_rows.hpp"

namespace markservo::target_locator {
namespace {

// One of the window's left pixels.
struct WindowPixel {
  float du;        // image px from the feature
  float dv;        // image px
  int row;         // patch px
  float grey;      // about the window's mean
  float gradient;  // Sobel's, per image px: the left factor of the normal equations, with little noise
};

// The left window and what follows from it alone.
struct Window {
  std::vector<WindowPixel> pixels;
  float mean = 0.0F;
  double energy = 0.0;  // sum of squared greys about the mean
  // Of (1, du, dv), weighted by the gradients.
  Eigen::Vector3f gradient_grey = Eigen::Vector3f::Zero();
  Eigen::Matrix3f newton = Eigen::Matrix3f::Zero();       // with the plain difference as right factor: the true slope
  Eigen::Matrix3f information = Eigen::Matrix3f::Zero();  // with the left factor again: what noise does
};

Window make_window(const StereoPatch& patch, const Feature& feature, int half, const Mask* support) {
  Window window;
  const PlaneImage& left = patch.left;
  const int x0 = std::max(1, feature.column - half);
  const int x1 = std::min(left.width - 2, feature.column + half);
  const int y0 = std::max(0, feature.row - half);
  const int y1 = std::min(left.height - 1, feature.row + half);
  const auto scale = static_cast<float>(patch.left_frame.scale);
  const std::size_t side = 2 * static_cast<std::size_t>(half) + 1;
  window.pixels.reserve(side * side);
  float sum = 0.0F;
  for (int y = y0; y <= y1; ++y) {
    const float* grey = left.row(y);
    const float* gradient = patch.left_gradients.column.row(y);
    for (int x = x0; x <= x1; ++x) {
      if (support != nullptr && support->at(x, y) == 0) continue;
      sum += grey[x];
      window.pixels.push_back({static_cast<float>(x - feature.column) * scale,
                               static_cast<float>(y - feature.row) * scale, y, grey[x], gradient[x] / scale});
      const float slope = 0.5F * (grey[x + 1] - grey[x - 1]) / scale;
      const WindowPixel& pixel = window.pixels.back();
      const Eigen::Vector3f along(1.0F, pixel.du, pixel.dv);
      window.newton += pixel.gradient * slope * along * along.transpose();
      window.information += pixel.gradient * pixel.gradient * along * along.transpose();
    }
  }
  if (window.pixels.empty()) return window;
  window.mean = sum / static_cast<float>(window.pixels.size());
  float energy = 0.0F;
  for (WindowPixel& pixel : window.pixels) {
    pixel.grey -= window.mean;
    energy += pixel.grey * pixel.grey;
    window.gradient_grey += pixel.gradient * pixel.grey * Eigen::Vector3f(1.0F, pixel.du, pixel.dv);
  }
  window.energy = static_cast<double>(energy);
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
  const auto base = static_cast<float>(patch.right_frame.column_of(u - local.disparity));
  const auto inverse_scale = static_cast<float>(1.0 / patch.right_frame.scale);
  const float per_u = (1.0F - static_cast<float>(local.along_u)) * inverse_scale;
  const float per_v = -static_cast<float>(local.along_v) * inverse_scale;
  if (!(base >= 2.0F) || !(base <= static_cast<float>(patch.right_rows.width) - 3.0F)) return std::nullopt;
  float sum = 0.0F;
  float squares = 0.0F;
  float product = 0.0F;
  float gradient_sum = 0.0F;
  float gradient_u = 0.0F;
  float gradient_v = 0.0F;
  Eigen::Vector3f gradient_right = Eigen::Vector3f::Zero();
  for (const WindowPixel& pixel : window.pixels) {
    const float right = sample_cubic(patch.right_rows.row(pixel.row), patch.right_rows.width,
                                     base + per_u * pixel.du + per_v * pixel.dv) -
                        window.mean;
    sum += right;
    squares += right * right;
    product += right * pixel.grey;
    gradient_sum += pixel.gradient;
    gradient_u += pixel.gradient * pixel.du;
    gradient_v += pixel.gradient * pixel.dv;
    gradient_right += pixel.gradient * right * Eigen::Vector3f(1.0F, pixel.du, pixel.dv);
  }
  const float offset = sum / static_cast<float>(window.pixels.size());
  Comparison result;
  result.energy = static_cast<double>(squares - sum * offset);
  result.product = static_cast<double>(product);
  result.gain = result.product / window.energy;
  const Eigen::Vector3f of_offset = offset * Eigen::Vector3f(gradient_sum, gradient_u, gradient_v);
  result.mismatch = (gradient_right - of_offset).cast<double>() - result.gain * window.gradient_grey.cast<double>();
  return result;
}

// The inverse for the disparity alone, or for its slopes as well; the rest is 0.
Eigen::Matrix3d step_matrix(const Window& window, bool solve_slopes) {
  const Eigen::Matrix3d newton = window.newton.cast<double>();
  if (solve_slopes) return newton.inverse();
  Eigen::Matrix3d step = Eigen::Matrix3d::Zero();
  step(0, 0) = 1.0 / newton(0, 0);
  return step;
}

}  // namespace

std::optional<RefinedMatch> refine_match(const StereoPatch& patch, const Feature& feature, const LocalDisparity& start,
                                         const Mask* support, const RefinementParameters& parameters) {
  constexpr double kSteepest = 1.5;     // px per px
  constexpr double kLargestGain = 5.0;  // between two cameras that see the same
  const int side = 2 * parameters.half_window + 1;
  const Window window = make_window(patch, feature, parameters.half_window, support);
  const auto n = static_cast<double>(window.pixels.size());
  // A quarter of the window and a few more, with at least one grey level of contrast.
  if (n < 0.25 * side * side + 6.0 || !(window.energy > n) || !(window.newton(0, 0) > 1e-6F)) return std::nullopt;
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
  const Eigen::Matrix3d covariance = variance * step * window.information.cast<double>() * step.transpose();
  match.sigma = std::sqrt(std::max(0.0, covariance(0, 0)));
  return match;
}

}  // namespace markservo::target_locator
