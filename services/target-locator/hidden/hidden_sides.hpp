#pragma once

// The centre of a square of known size of which something nearer hides a part.
//
// What both views show of the mark is laid onto its plane in space. The square must hold all of it, so that along each
// of its two axes either both its sides are seen, one size apart, or some of it is missing, and then it must be told
// which of the two outermost edges is a side of the square and which is the edge of what hides it. A side is straight
// and parallel to the square, and both cameras see it at the same place of the plane, where they see the edge of
// something nearer at different places. Where this does not decide, the centre lies between the possible ones and its
// covariance spans them.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/hidden/hidden_sides_parameters.hpp"
#include "services/target-locator/hidden/plane_outlines.hpp"
#include "services/target-locator/image/image_centre.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

// Where the left image shows the centre of the square of edge `size` (m, above 0), with what is not known of it in the
// covariance. `row_offset` (px) is what the right view lies lower than its rows say. Nothing when the masks hold too
// little or more than such a square, or the plane is not in front of the cameras.
std::optional<ImageCentre> centre_of_hidden_square(const MaskedView& left, const MaskedView& right,
                                                   const DisparityPlane& plane, double row_offset,
                                                   const geometry::StereoCamera& camera, double size,
                                                   const HiddenSidesParameters& parameters);

}  // namespace markservo::target_locator
