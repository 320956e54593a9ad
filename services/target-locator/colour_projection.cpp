#include "services/target-locator/colour_projection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "services/target-locator/pixel_kernel.hpp"

namespace markservo::target_locator {
namespace {

const Eigen::Vector3f kGreyAxis(0.114F, 0.587F, 0.299F);  // luma of B, G, R
constexpr int kEdgeMargin = 2;       // patch px on either side of the outline that belong to neither class
constexpr int kRingReach = 5;        // patch px, how far the ring of surroundings reaches
constexpr float kSameColour = 6.0F;  // grey levels between mark and ring below which no outline can be measured

Eigen::Vector3d mean_of(const ColourSums& sums) {
  const double n = static_cast<double>(std::max<std::int64_t>(sums.count, 1));
  return Eigen::Vector3d(static_cast<double>(sums.first[0]), static_cast<double>(sums.first[1]),
                         static_cast<double>(sums.first[2])) /
         n;
}

Eigen::Matrix3d covariance_of(const ColourSums& sums) {
  const double n = static_cast<double>(std::max<std::int64_t>(sums.count, 1));
  const auto second = [&sums](std::size_t i) { return static_cast<double>(sums.second[i]); };
  Eigen::Matrix3d moments;
  moments << second(0), second(1), second(2), second(1), second(3), second(4), second(2), second(4), second(5);
  const Eigen::Vector3d m = mean_of(sums);
  return moments / n - m * m.transpose();
}

// Square erosion (keep_minimum) or dilation by `pixels`, separable; pixels beyond the border count as 0.
Mask morph(const Mask& mask, int pixels, bool keep_minimum) {
  const int w = mask.width;
  const int h = mask.height;
  Mask across(w, h);
  for (int y = 0; y < h; ++y) {
    const unsigned char* in = mask.row(y);
    unsigned char* out = across.row(y);
    std::copy(in, in + w, out);
    for (int k = -pixels; k <= pixels; ++k) {
      if (k == 0) continue;
      const int from = std::max(0, -k);
      const int to = std::min(w, w - k);
      if (keep_minimum) {
        for (int x = from; x < to; ++x) out[x] = static_cast<unsigned char>(out[x] & in[x + k]);
        for (int x = 0; x < std::min(from, w); ++x) out[x] = 0;
        for (int x = std::max(to, 0); x < w; ++x) out[x] = 0;
      } else {
        for (int x = from; x < to; ++x) out[x] = static_cast<unsigned char>(out[x] | in[x + k]);
      }
    }
  }
  Mask result(w, h);
  for (int y = 0; y < h; ++y) {
    unsigned char* out = result.row(y);
    std::copy(across.row(y), across.row(y) + w, out);
    for (int k = -pixels; k <= pixels; ++k) {
      if (k == 0) continue;
      if (y + k < 0 || y + k >= h) {
        if (keep_minimum) std::memset(out, 0, static_cast<std::size_t>(w));
        continue;
      }
      const unsigned char* in = across.row(y + k);
      if (keep_minimum) {
        for (int x = 0; x < w; ++x) out[x] = static_cast<unsigned char>(out[x] & in[x]);
      } else {
        for (int x = 0; x < w; ++x) out[x] = static_cast<unsigned char>(out[x] | in[x]);
      }
    }
  }
  return result;
}

}  // namespace

Mask unpack_mask(const Patch& patch) {
  Mask mask(patch.width, patch.height);
  const int stride = (patch.width + 7) / 8;
  for (int y = 0; y < patch.height; ++y) {
    const std::uint8_t* bits = patch.mask + static_cast<std::ptrdiff_t>(y) * stride;
    unsigned char* out = mask.row(y);
    for (int x = 0; x < patch.width; ++x) out[x] = static_cast<unsigned char>((bits[x >> 3] >> (x & 7)) & 1);
  }
  return mask;
}

PlaneImage project_colours(const Patch& patch, const Eigen::Vector3f& weights) {
  PlaneImage plane(patch.width, patch.height);
  project_pixels(patch.bgr, plane.data.size(), {weights[0], weights[1], weights[2]}, plane.data.data());
  return plane;
}

Eigen::Vector3f texture_axis(const Patch& patch, const Mask& mask) {
  const ColourSums sums = sum_colours(patch.bgr, mask.data.data(), mask.data.size());
  const Eigen::Matrix3d covariance = covariance_of(sums);
  if (sums.count < 2 || !(covariance.trace() > 1e-6)) return kGreyAxis.normalized();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  Eigen::Vector3d axis = solver.eigenvectors().col(2);
  if (!axis.allFinite()) return kGreyAxis.normalized();
  if (axis.sum() < 0.0) axis = -axis;
  return axis.cast<float>();
}

Contrast mark_contrast(const Patch& patch, const Mask& mask) {
  const Mask inner = erode(mask, kEdgeMargin);
  const Mask near = morph(mask, kEdgeMargin, false);
  Mask ring = morph(mask, kRingReach, false);
  for (std::size_t i = 0; i < ring.data.size(); ++i) {
    ring.data[i] = static_cast<unsigned char>(ring.data[i] & (near.data[i] ^ 1U));
  }
  const ColourSums inside = sum_colours(patch.bgr, inner.data.data(), inner.data.size());
  const ColourSums outside = sum_colours(patch.bgr, ring.data.data(), ring.data.size());
  Contrast contrast;
  if (inside.count < 9 || outside.count < 9) return contrast;
  const Eigen::Vector3d gap = mean_of(inside) - mean_of(outside);
  if (gap.norm() < static_cast<double>(kSameColour)) return contrast;
  // The ridge keeps noise-free pictures solvable and is the variance of rounding to whole grey levels, and then some.
  const Eigen::Matrix3d within = covariance_of(inside) + covariance_of(outside) + 2.0 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d weights = within.inverse() * gap;
  const double span = weights.dot(gap);
  if (!(span > 0.0) || !weights.allFinite()) return contrast;
  weights /= span;
  contrast.weights = weights.cast<float>();
  contrast.offset = static_cast<float>(-weights.dot(mean_of(outside)));
  contrast.valid = true;
  return contrast;
}

Mask erode(const Mask& mask, int pixels) {
  return morph(mask, pixels, true);
}

}  // namespace markservo::target_locator
