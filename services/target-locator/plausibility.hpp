#pragma once

// What can be worked on, and what may be answered.

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// Finite everywhere, fx, fy and baseline above 0.
bool valid_camera(const geometry::StereoCamera& camera);

// There is a patch with room for a feature, and a box.
bool is_usable(const View& view);

// Could the two boxes be one mark's? Rows must overlap, sizes be of one order, and the mark lie in front.
bool boxes_agree(const View& left, const View& right, const geometry::StereoCamera& camera);

// Numbers as a real mark can have them; those of a camera or a box beyond all measure end elsewhere.
bool is_possible(const Location& location);

}  // namespace markservo::target_locator
