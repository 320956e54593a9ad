#pragma once

// The two views of a mark, ready for matching, and the disparities of a plane between them.

#include "services/target-locator/features/structure_tensor.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// Disparity u_left - u_right (image px) over the left image. A plane in space has exactly this form.
struct DisparityPlane {
  double u0 = 0.0;         // px, left image: where `at_centre` holds
  double v0 = 0.0;         // px
  double at_centre = 0.0;  // px
  double along_u = 0.0;    // px per px
  double along_v = 0.0;    // px per px

  double at(double u, double v) const { return at_centre + along_u * (u - u0) + along_v * (v - v0); }
};

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
