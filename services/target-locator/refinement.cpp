#include "services/target-locator/refinement.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "services/target-locator/epipolar_rows.hpp"

namespace markservo::target_locator {
namespace {

// The window's pixels about the feature: position, grey about the mean, gradients per image px.
struct WindowPixel {
  float du;  // image px
  float dv;  // image px
  int column;
  int row;
  float grey;
  float gradient;
  float slope;
};

struct WindowSums {
  double right = 0.0;
  double right_squared = 0.0;
  double left_right = 0.0;
};

}  // namespace

std::optional<RefinedMatch> refine_match(const StereoPatch& patch, const Feature& feature, const LocalDisparity& start,
                                         const Mask* support, const RefinementParameters& parameters) {
  const int half = parameters.half_window;
  const PlaneImage& left = patch.left;
  const int x0 = std::max(1, feature.column - half);
  const int x1 = std::min(left.width - 2, feature.column + half);
  const int y0 = std::max(0, feature.row - half);
  const int y1 = std::min(left.height - 1, feature.row + half);
  const auto scale = static_cast<float>(patch.left_frame.scale);

  std::vector<WindowPixel> window;
  window.reserve(static_cast<std::size_t>((2 * half + 1) * (2 * half + 1)));
  double sum = 0.0;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (support != nullptr && support->at(x, y) == 0) continue;
      WindowPixel pixel{};
      pixel.du = static_cast<float>(x - feature.column) * scale;
      pixel.dv = static_cast<float>(y - feature.row) * scale;
      pixel.column = x;
      pixel.row = y;
      pixel.grey = left.at(x, y);
      pixel.gradient = patch.left_gradients.column.at(x, y) / scale;
      pixel.slope = 0.5F * (left.at(x + 1, y) - left.at(x - 1, y)) / scale;
      sum += static_cast<double>(pixel.grey);
      window.push_back(pixel);
    }
  }
  const auto n = static_cast<double>(window.size());
  if (window.size() < static_cast<std::size_t>((2 * half + 1) * (2 * half + 1) / 4 + 6)) return std::nullopt;
  const auto mean = static_cast<float>(sum / n);
  // Without slopes the disparity is the only unknown besides gain and offset.
  const int unknowns = parameters.solve_slopes ? 3 : 1;
  Eigen::Vector3d gradient_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d gradient_grey = Eigen::Vector3d::Zero();
  Eigen::Matrix3d newton = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  double grey_squared = 0.0;
  for (WindowPixel& pixel : window) {
    pixel.grey -= mean;
    const Eigen::Vector3d along(1.0, static_cast<double>(pixel.du), static_cast<double>(pixel.dv));
    const auto g = static_cast<double>(pixel.gradient);
    gradient_sum += g * along;
    gradient_grey += g * static_cast<double>(pixel.grey) * along;
    newton += g * static_cast<double>(pixel.slope) * along * along.transpose();
    information += g * g * along * along.transpose();
    grey_squared += static_cast<double>(pixel.grey) * static_cast<double>(pixel.grey);
  }
  if (!(grey_squared > n) || !(newton(0, 0) > 1e-6)) return std::nullopt;
  const Eigen::MatrixXd inverse = newton.topLeftCorner(unknowns, unknowns).inverse();
  if (!inverse.allFinite()) return std::nullopt;

  LocalDisparity local = start;
  std::vector<float> warped(window.size());
  WindowSums sums;
  double gain = 1.0;
  const double u = patch.left_frame.u_of(feature.column);
  const auto sample = [&]() {
    const auto base = static_cast<float>(patch.right_frame.column_of(u - local.disparity));
    const auto inverse_scale = static_cast<float>(1.0 / patch.right_frame.scale);
    const float per_u = (1.0F - static_cast<float>(local.along_u)) * inverse_scale;
    const float per_v = -static_cast<float>(local.along_v) * inverse_scale;
    const auto width = static_cast<float>(patch.right_rows.width);
    if (!(base >= 2.0F) || !(base <= width - 3.0F)) return false;
    sums = WindowSums();
    for (std::size_t i = 0; i < window.size(); ++i) {
      const WindowPixel& pixel = window[i];
      const float r = sample_cubic(patch.right_rows.row(pixel.row), patch.right_rows.width,
                                   base + per_u * pixel.du + per_v * pixel.dv);
      warped[i] = r;
      const auto value = static_cast<double>(r);
      sums.right += value;
      sums.right_squared += value * value;
      sums.left_right += value * static_cast<double>(pixel.grey);
    }
    gain = sums.left_right / grey_squared;
    return true;
  };
  for (int k = 0; k < parameters.max_iterations; ++k) {
    if (!sample() || !(gain > 0.2) || !(gain < 5.0)) return std::nullopt;
    const double offset = sums.right / n;
    // Left and right factor as in align_plane; the window's gain and offset are fitted in closed form.
    Eigen::Vector3d gradient_right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < window.size(); ++i) {
      const WindowPixel& pixel = window[i];
      const double gr = static_cast<double>(pixel.gradient) * static_cast<double>(warped[i]);
      gradient_right += gr * Eigen::Vector3d(1.0, static_cast<double>(pixel.du), static_cast<double>(pixel.dv));
    }
    const Eigen::Vector3d mismatch = gradient_right - gain * gradient_grey - offset * gradient_sum;
    const Eigen::VectorXd change = inverse * mismatch.head(unknowns) / gain;
    if (!change.allFinite()) return std::nullopt;
    local.disparity += change[0];
    if (unknowns == 3) {
      local.along_u += change[1];
      local.along_v += change[2];
    }
    if (!(std::abs(local.disparity - start.disparity) <= parameters.max_change_px)) return std::nullopt;
    if (std::abs(local.along_u) > 1.0 || std::abs(local.along_v) > 1.5) return std::nullopt;
    if (std::abs(change[0]) < parameters.settled_px) break;
  }
  if (!sample()) return std::nullopt;
  const double right_variance = sums.right_squared - sums.right * sums.right / n;
  if (!(right_variance > 0.0)) return std::nullopt;
  RefinedMatch match;
  match.local = local;
  match.correlation = sums.left_right / std::sqrt(grey_squared * right_variance);
  if (!(match.correlation >= parameters.min_correlation)) return std::nullopt;
  const double residual = std::max(0.0, right_variance - sums.left_right * sums.left_right / grey_squared);
  const double variance = residual / std::max(1.0, n - unknowns - 2);
  const Eigen::MatrixXd covariance =
      variance / (gain * gain) * inverse * information.topLeftCorner(unknowns, unknowns) * inverse.transpose();
  match.sigma = std::sqrt(std::max(0.0, covariance(0, 0)));
  return match;
}

}  // namespace markservo::target_locator
