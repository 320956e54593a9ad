#include "services/target-locator/colour_projection.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace markservo::target_locator {
namespace {

const Eigen::Vector3f kGreyAxis(0.114F, 0.587F, 0.299F);  // luma of B, G, R
constexpr int kEdgeMargin = 2;       // patch px on either side of the outline that belong to neither class
constexpr int kRingReach = 5;        // patch px, how far the ring of surroundings reaches
constexpr float kSameColour = 6.0F;  // grey levels between mark and ring below which no outline can be measured

// Sums of one class of pixels. 32-bit sums per row keep the inner loop cheap; int64 totals are exact.
struct ColourSums {
  std::int64_t count = 0;
  std::int64_t first[3] = {0, 0, 0};
  std::int64_t second[6] = {0, 0, 0, 0, 0, 0};  // bb, bg, br, gg, gr, rr

  void add(const std::uint8_t* bgr) {
    const std::int64_t b = bgr[0];
    const std::int64_t g = bgr[1];
    const std::int64_t r = bgr[2];
    ++count;
    first[0] += b;
    first[1] += g;
    first[2] += r;
    second[0] += b * b;
    second[1] += b * g;
    second[2] += b * r;
    second[3] += g * g;
    second[4] += g * r;
    second[5] += r * r;
  }
  Eigen::Vector3d mean() const {
    const double n = static_cast<double>(std::max<std::int64_t>(count, 1));
    return Eigen::Vector3d(static_cast<double>(first[0]), static_cast<double>(first[1]),
                           static_cast<double>(first[2])) /
           n;
  }
  Eigen::Matrix3d covariance() const {
    const double n = static_cast<double>(std::max<std::int64_t>(count, 1));
    Eigen::Matrix3d moments;
    moments << static_cast<double>(second[0]), static_cast<double>(second[1]), static_cast<double>(second[2]),
        static_cast<double>(second[1]), static_cast<double>(second[3]), static_cast<double>(second[4]),
        static_cast<double>(second[2]), static_cast<double>(second[4]), static_cast<double>(second[5]);
    const Eigen::Vector3d m = mean();
    return moments / n - m * m.transpose();
  }
};

const std::uint8_t* pixel(const Patch& patch, int x, int y) {
  return patch.bgr + 3 * (static_cast<std::ptrdiff_t>(y) * patch.width + x);
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
  const std::size_t count = plane.data.size();
  const float wb = weights[0];
  const float wg = weights[1];
  const float wr = weights[2];
  const std::uint8_t* in = patch.bgr;
  for (std::size_t i = 0; i < count; ++i, in += 3) {
    plane.data[i] = wb * static_cast<float>(in[0]) + wg * static_cast<float>(in[1]) + wr * static_cast<float>(in[2]);
  }
  return plane;
}

Eigen::Vector3f texture_axis(const Patch& patch, const Mask& mask) {
  ColourSums sums;
  for (int y = 0; y < patch.height; ++y) {
    const unsigned char* inside = mask.row(y);
    for (int x = 0; x < patch.width; ++x) {
      if (inside[x] != 0) sums.add(pixel(patch, x, y));
    }
  }
  const Eigen::Matrix3d covariance = sums.covariance();
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
  const Mask far = morph(mask, kRingReach, false);
  ColourSums inside;
  ColourSums outside;
  for (int y = 0; y < patch.height; ++y) {
    const unsigned char* in = inner.row(y);
    const unsigned char* skip = near.row(y);
    const unsigned char* ring = far.row(y);
    for (int x = 0; x < patch.width; ++x) {
      if (in[x] != 0) {
        inside.add(pixel(patch, x, y));
      } else if (ring[x] != 0 && skip[x] == 0) {
        outside.add(pixel(patch, x, y));
      }
    }
  }
  Contrast contrast;
  if (inside.count < 9 || outside.count < 9) return contrast;
  const Eigen::Vector3d gap = inside.mean() - outside.mean();
  if (gap.norm() < static_cast<double>(kSameColour)) return contrast;
  // The ridge keeps noise-free pictures solvable and is the variance of rounding to whole grey levels, and then some.
  const Eigen::Matrix3d within = inside.covariance() + outside.covariance() + 2.0 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d weights = within.inverse() * gap;
  const double span = weights.dot(gap);
  if (!(span > 0.0) || !weights.allFinite()) return contrast;
  weights /= span;
  contrast.weights = weights.cast<float>();
  contrast.offset = static_cast<float>(-weights.dot(outside.mean()));
  contrast.valid = true;
  return contrast;
}

Mask erode(const Mask& mask, int pixels) {
  return morph(mask, pixels, true);
}

}  // namespace markservo::target_locator
