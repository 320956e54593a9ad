#pragma once

// What can be worked on, and what may be answered.

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// Whether all numbers are finite, and fx, fy and baseline above 0.
bool valid_camera(const geometry::StereoCamera& camera);

// Whether the view has a patch with room for a feature, and a box.
bool is_usable(const View& view);

// Whether the two boxes could be one mark's. Rows must overlap, sizes be of one order, and the mark lie in front.
bool boxes_agree(const View& left, const View& right, const geometry::StereoCamera& camera);

// Whether a real mark can have such numbers; a camera or a box beyond all measure leads to others.
bool is_possible(const Location& location);

}  // namespace markservo::target_locator
