#pragma once

// The pixels about an outline, in blocks of a few pixels of outline each.

#include <vector>

#include "services/target-locator/contour/coverage.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

struct ContourPixel {
  double x = 0.0;  // patch px
  double y = 0.0;  // patch px
  double value = 0.0;
  std::size_t block = 0;
};

struct ContourPixels {
  std::vector<ContourPixel> pixels;
  std::vector<bool> used;  // of each block
};

// The pixels from `reach_in` px inside the outline to `reach_out` px outside, in `blocks` blocks of equal length.
template <class Shape>
ContourPixels pixels_about(const PlaneImage& image, const Shape& shape, double reach_in, double reach_out,
                           std::size_t blocks) {
  constexpr double kSharp = 1e-3;  // only distances are asked
  ContourPixels about;
  about.used.assign(blocks, true);
  for (int y = 0; y < image.height; ++y) {
    const float* row = image.row(y);
    for (int x = 0; x < image.width; ++x) {
      const Coverage coverage = shape.at(x, y, kSharp);
      if (!(coverage.distance > -reach_out && coverage.distance < reach_in)) continue;
      const auto block = static_cast<std::size_t>(coverage.around * static_cast<double>(blocks));
      about.pixels.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(row[x]),
                              block < blocks ? block : blocks - 1});
    }
  }
  return about;
}

}  // namespace markservo::target_locator
