#pragma once

// Everything that is made of a mark's two patches before anything is matched.

#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/mark_masks.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

struct MarkImages {
  StereoPatch patch;
  MarkMasks left;
  MarkMasks right;
  MarkColours left_colours;
};

// Both patches on the grey axis that shows the left one's texture best, the right one's rows aligned to the left one's.
// `images` keeps its memory. Both views must have a patch.
void make_mark_images(const View& left, const View& right, MarkImages& images);

}  // namespace markservo::target_locator
