#pragma once

// From colour to the one grey plane that shows best what is looked for.

#include <Eigen/Core>
#include <cstdint>

#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// The mark's mask with one byte a pixel.
Mask unpack_mask(const Patch& patch);

// weights . (b, g, r) of every pixel.
PlaneImage project_colours(const Patch& patch, const Eigen::Vector3f& weights);

// The axis of BGR along which the masked pixels vary most, unit length, sum not negative: what a printed texture looks
// like under noise of equal size in the three channels. Grey where the masked pixels do not vary.
Eigen::Vector3f texture_axis(const Patch& patch, const Mask& mask);

// Fisher's discriminant between the mark and its surroundings: an affine map of BGR that is 1 on average well inside
// the mask and 0 in a ring around it, with the least variation within both.
struct Contrast {
  Eigen::Vector3f weights = Eigen::Vector3f::Zero();
  float offset = 0.0F;
  bool valid = false;  // false: no inside, no ring, or the two look the same
};
Contrast mark_contrast(const Patch& patch, const Mask& mask);

// The mask without the pixels nearer than `pixels` to a pixel outside it (square neighbourhood, border is outside).
Mask erode(const Mask& mask, int pixels);

}  // namespace markservo::target_locator
