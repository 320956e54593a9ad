#pragma once

// What a mask alone says of a flat mark.

#include <optional>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/image/image_centre.hpp"
#include "services/target-locator/image/patch_frame.hpp"
#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/plane/disparity_plane.hpp"

namespace markservo::target_locator {

// Where the image shows the mark's centre, by the mask alone: its pixels weighted by Z^3, which is the area of the
// plane that a pixel covers, so that the nearer half of a slanted mark does not count more than the farther one.
// `camera` is used for its principal points only. Nothing for an empty mask or a plane that is not in front of the
// cameras.
std::optional<ImageCentre> centre_of_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                          const geometry::StereoCamera& camera, CameraSide side);

// What the mask covers of the plane in space, m^2. Nothing where centre_of_mask gives nothing.
std::optional<double> area_on_plane(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                    const geometry::StereoCamera& camera, CameraSide side);

}  // namespace markservo::target_locator
