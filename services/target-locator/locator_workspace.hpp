#pragma once

// What the locator makes of one mark's patches on the way, in memory that is used again for the next.

#include <vector>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/features/structure_tensor.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/plane/mark_plane.hpp"

namespace markservo::target_locator {

struct LocatorWorkspace {
  MarkImages images;
  CornerMeasures measures;
  std::vector<Feature> features;
  PlaneWorkspace plane;
  PlaneImage contrast;
};

}  // namespace markservo::target_locator
