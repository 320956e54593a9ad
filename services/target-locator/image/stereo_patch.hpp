#pragma once

// The two views of a mark, ready for matching.

#include "services/target-locator/image/gradients.hpp"
#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// The two views of one mark as grey planes.
struct StereoPatch {
  PlaneImage left;
  PatchFrame left_frame;
  Gradients left_gradients;
  PlaneImage right;       // as cut
  PlaneImage right_rows;  // aligned to the left patch's rows
  PatchFrame right_frame;
};

}  // namespace markservo::target_locator
