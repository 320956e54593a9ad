#pragma once

// The sides of a square mark by its mask alone: where fitting them begins.

#include <optional>

#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/outline/image_line.hpp"

namespace markservo::target_locator {

// The parallelogram with the mask's first, second and fourth moments: exact for a square under any affine map. Normals
// point outwards. Nothing for small masks and those whose fourth moment is below `min_squareness` of a square's.
std::optional<Lines> lines_from_moments(const Mask& mask, double min_squareness);

}  // namespace markservo::target_locator
