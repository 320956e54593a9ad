#pragma once

// What stands behind the marks.

#include <Eigen/Core>
#include <random>

#include "tests/scenes/printed_surface.hpp"

namespace markservo::scenes {

// A wall, at 0.45 m, that fills the images.
Surface wall(unsigned seed);

// A book's back that faces the cameras, of any hue but muted: equalisation as OpenCV does it raises saturation in the
// dark.
Surface muted_book(const Eigen::Vector3d& centre, std::mt19937& random);

}  // namespace markservo::scenes
