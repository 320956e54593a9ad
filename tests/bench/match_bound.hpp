#pragma once

// The Cramer-Rao bounds of disparities measured in a mark's noise-free view.

#include <Eigen/Core>

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::bench {

// A noise-free view in the projection that a matcher looks at.
struct NoiseFreeView {
  target_locator::PlaneImage grey;
  target_locator::PlaneImage change_along_u;  // grey levels per px
};

// Standard deviation (px) that no unbiased estimate of the disparity of the pixels of `window` (1: used) goes below,
// where gain and offset between the views are unknown and both have noise of `sigma`. Infinite without texture.
double disparity_bound(const NoiseFreeView& view, const target_locator::Mask& window, double sigma);

// The same for the disparity at (column, row) of a plane over the pixels of `window`, its slopes unknown as well.
double plane_bound(const NoiseFreeView& view, const target_locator::Mask& window, double sigma, double column,
                   double row);

}  // namespace markservo::bench
