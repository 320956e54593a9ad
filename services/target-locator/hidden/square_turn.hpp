#pragma once

// How a square is turned on its plane, of which the outlines may show a part only.

#include <optional>

#include "services/target-locator/hidden/plane_outlines.hpp"

namespace markservo::target_locator {

// The turn (rad, within 45 degrees) of the square whose sides most of the outlines lie on. Nothing when these extend
// over more than `most_extent` (m) whatever the turn.
std::optional<double> best_turn(const PlaneOutlines& outlines, double most_extent);

// The turn that most of the outermost edges by length are parallel to, from one near it. What hides has edges of its
// own, but hardly as many that are parallel or square to each other.
double aligned_turn(const PlaneOutlines& outlines, double turn);

}  // namespace markservo::target_locator
