#pragma once

// The outlines of what two views show of a mark, laid onto its plane in space.

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "services/target-locator/hidden/plane_axes.hpp"
#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// One camera's view of the mark.
struct MaskedView {
  const Mask& mask;
  const PatchFrame& frame;
};

using Points = std::vector<Eigen::Vector2d>;  // m, on the plane

struct PlaneOutlines {
  std::array<Points, 2> views;  // left, right
  double pixel = 0.0;           // m, a patch pixel on the plane
};

// `row_offset` (px) is what the right view lies lower than its rows say. Nothing when a view shows too little or lies
// in part where the plane is not in front of the cameras.
std::optional<PlaneOutlines> outlines_on_plane(const MaskedView& left, const MaskedView& right, const PlaneAxes& axes,
                                               const DisparityPlane& plane, double row_offset, double fx);

}  // namespace markservo::target_locator
