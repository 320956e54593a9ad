#pragma once

// Which of a mark's pixels both cameras see: what is nearer hides different parts of it from each.

#include <vector>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

// The pixels of `left` that the plane of disparities puts on pixels of `right`. `both` keeps its memory.
void seen_by_both(const Mask& left, const PatchFrame& left_frame, const Mask& right, const PatchFrame& right_frame,
                  const DisparityPlane& plane, Mask& both);

// Takes away the features that do not lie on pixels of `mask`.
void keep_within(const Mask& mask, std::vector<Feature>& features);

}  // namespace markservo::target_locator
