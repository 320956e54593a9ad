#pragma once

// From colour to the one grey plane that shows best what is looked for.

#include <Eigen/Core>
#include <cstdint>

#include "common/imaging/colour_sums.hpp"
#include "services/target-locator/image/image_kernel.hpp"
#include "services/target-locator/image/mark_masks.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// What a patch's mark and its surroundings look like; of every other row.
struct MarkColours {
  imaging::ColourSums inside;  // well inside the mask
  imaging::ColourSums around;  // in a ring around it
};

// The colours of the mark of prepared masks; makes their ring.
MarkColours mark_colours(const Patch& patch, MarkMasks& masks);

// The axis of BGR along which these pixels vary most, unit length, sum not negative: what a printed texture looks like
// under noise of equal size in the three channels. Grey where they do not vary.
ColourMap texture_axis(const imaging::ColourSums& inside);

// Fisher's discriminant between the mark and its surroundings: an affine map of BGR that is 1 on average well inside
// the mask and 0 in a ring around it, with the least variation within both.
struct Contrast {
  ColourMap map;
  bool valid = false;  // false: no inside, no ring, or the two look the same
};
Contrast mark_contrast(const MarkColours& colours);

// The map of every pixel of the patch.
void project_colours(const Patch& patch, const ColourMap& map, PlaneImage& plane);

}  // namespace markservo::target_locator
