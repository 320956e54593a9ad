#pragma once

// Where in its patch a mark is, surely is, and surely is not.

#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// The mark's mask with its rows in words. `mask` keeps its memory.
void unpack_mask(const Patch& patch, Mask& mask);
Mask unpack_mask(const Patch& patch);

// A mark's mask and what is well inside of it.
struct MarkMasks {
  Mask mask;
  Mask inner;  // without the pixels at the outline that may show the background
  Mask ring;   // the surroundings, a few pixels away and a few pixels wide
  Mask reach;  // the mask, these few pixels, and the ring
};

// Unpacks the patch's mask and makes the inner one; they keep their memory.
void prepare_masks(const Patch& patch, MarkMasks& masks);

// Makes the ring of prepared masks.
void make_ring(MarkMasks& masks);

}  // namespace markservo::target_locator
