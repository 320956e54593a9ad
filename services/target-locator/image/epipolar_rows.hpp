#pragma once

// Sampling the right image along the left image's rows.

#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// Weights of Catmull-Rom's cubic for the samples at -1, 0, 1, 2 around a position `t` of [0, 1).
struct CubicWeights {
  float w[4];
  explicit CubicWeights(float t) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    w[0] = 0.5F * (-t3 + 2.0F * t2 - t);
    w[1] = 0.5F * (3.0F * t3 - 5.0F * t2 + 2.0F);
    w[2] = 0.5F * (-3.0F * t3 + 4.0F * t2 + t);
    w[3] = 0.5F * (t3 - t2);
  }
};

// `line` (of `width` >= 4 pixels) at column `x`; the outermost cubic goes on beyond the border's neighbours.
inline float sample_cubic(const float* line, int width, float x) {
  const float limited =
      x < 1.0F ? 1.0F : (x > static_cast<float>(width) - 2.001F ? static_cast<float>(width) - 2.001F : x);
  const int i = static_cast<int>(limited);
  const CubicWeights c(limited - static_cast<float>(i));
  const float* p = line + i - 1;
  return c.w[0] * p[0] + c.w[1] * p[1] + c.w[2] * p[2] + c.w[3] * p[3];
}

// The right image resampled so that its row r shows what the left image's row r shows: the rows of a rectified pair are
// epipolar lines, but the patches may start at different rows and be averaged by different scales. `row_offset` (image
// px) is what a right point lies lower than its left one. Columns stay as they are; rows outside repeat the border.
// `aligned` keeps its memory.
void align_rows(const PlaneImage& right, const PatchFrame& right_frame, const PatchFrame& left_frame, int left_height,
                double row_offset, PlaneImage& aligned);
PlaneImage align_rows(const PlaneImage& right, const PatchFrame& right_frame, const PatchFrame& left_frame,
                      int left_height, double row_offset);

}  // namespace markservo::target_locator
