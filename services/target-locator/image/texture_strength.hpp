#pragma once

// How much of a plane's variation is texture and not noise.

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// Standard deviation of the texture among the mask's pixels, grey levels: from how alike neighbours in a row are, for
// noise differs from pixel to pixel. A rise over the mark, as light from one side makes it, is not counted. 0 for fewer
// than 16 pairs.
double texture_strength(const PlaneImage& image, const Mask& mask);

}  // namespace markservo::target_locator
