#pragma once

// The left pixels that a plane of disparities is fitted to, and what the right view shows at them.

#include <cstddef>
#include <vector>

#include "services/target-locator/stereo_patch.hpp"

namespace markservo::target_locator {

// Masked left pixels in reading order, value by value; behind them zeros up to a multiple of kLanes.
struct PlaneTemplate {
  static constexpr std::size_t kLanes = 16;  // floats of the longest vectors

  std::vector<float> column;      // patch px
  std::vector<int> row;           // patch px
  std::vector<float> along_u;     // from the centre, in half extents
  std::vector<float> along_v;     // from the centre, in half extents
  std::vector<float> grey;        // about the mean
  std::vector<float> gradient_u;  // Sobel's, per image px
  std::vector<float> gradient_v;  // Sobel's, per image px
  std::vector<float> slope_u;     // plain central difference, per image px
  std::vector<float> weight;      // 1 where used, else 0
  std::size_t count = 0;
  double u0 = 0.0;      // px of the image, the pixels' centre
  double v0 = 0.0;      // px
  double extent = 1.0;  // px of the image: rms distance from the centre

  std::size_t size() const { return count; }
  std::size_t padded() const { return column.size(); }
};

// Of the masked pixels every k-th, so that at most `limit` are taken.
PlaneTemplate make_template(const StereoPatch& patch, const Mask& mask, int limit);

// The right view's grey at every template pixel under the disparities of `plane`. The right view must be at least 4
// pixels wide; columns outside it repeat its border. `warped` gets pixels.padded() values.
void warp(const StereoPatch& patch, const PlaneTemplate& pixels, const DisparityPlane& plane,
          std::vector<float>& warped);

// Of the used template greys and the warped ones, -1..1; 0 when either does not vary.
double correlation_of(const PlaneTemplate& pixels, const std::vector<float>& warped);

}  // namespace markservo::target_locator
