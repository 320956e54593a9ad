#pragma once

// What the locator makes of one mark's patches on the way, in memory that is used again for the next.

#include <vector>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/features/structure_tensor.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/stereo_patch.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"

namespace markservo::target_locator {

struct LocatorWorkspace {
  StereoPatch patch;
  MarkMasks left;
  MarkMasks right;
  Mask common;  // what is well inside in both views
  MarkColours left_colours;
  CornerMeasures measures;
  std::vector<Feature> features;
  PlaneTemplates pixels;
  PlaneImage contrast;
};

}  // namespace markservo::target_locator
