#pragma once

// The left pixels that a plane of disparities is fitted to, and what the right view shows at them.

#include <cstddef>
#include <vector>

#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

// Blocks of kLanes neighbouring left pixels of a row; those that do not count have weight 0, and zeros elsewhere.
struct PlaneTemplate {
  static constexpr std::size_t kLanes = PlaneImage::kRoom;

  struct Block {
    int column = 0;  // patch px, of its first pixel
    int row = 0;     // patch px
  };

  // Where coordinates count from, and in what unit.
  struct Origin {
    double u = 0.0;       // px of the image, the pixels' centre
    double v = 0.0;       // px
    double extent = 1.0;  // px of the image: rms distance from the centre
  };

  std::vector<Block> blocks;
  // Value by value, kLanes a block.
  std::vector<float> along_u;     // from the origin, in its extents
  std::vector<float> along_v;     // from the origin, in its extents
  std::vector<float> grey;        // about the mean
  std::vector<float> gradient_u;  // Sobel's, per image px
  std::vector<float> gradient_v;  // Sobel's, per image px
  std::vector<float> slope_u;     // plain central difference, per image px
  std::vector<float> weight;      // 1 where used, else 0
  std::size_t count = 0;          // of pixels
  Origin origin;
  double mean_grey = 0.0;  // that greys are about

  std::size_t size() const { return count; }
  std::size_t padded() const { return blocks.size() * kLanes; }
};

// Left pixels to fit to: few, and about all.
struct PlaneTemplates {
  PlaneTemplate rough;
  PlaneTemplate all;
  std::vector<float> warped;  // what the right view shows at those worked on last
  std::vector<float> residual;
};

// Makes the template of about `limit` masked pixels, those of every k-th row. `pixels` keeps its memory.
void make_template(const StereoPatch& patch, const Mask& mask, int limit, PlaneTemplate& pixels);

// The right view's grey at every template pixel under the disparities of `plane`. The right view must be at least 4
// pixels wide; columns outside it repeat its border. `warped` gets pixels.padded() values.
void warp(const StereoPatch& patch, const PlaneTemplate& pixels, const DisparityPlane& plane,
          std::vector<float>& warped);

// Correlation of the used template greys and the warped ones, -1..1; 0 when either does not vary.
double correlation_of(const PlaneTemplate& pixels, const std::vector<float>& warped);

}  // namespace markservo::target_locator
