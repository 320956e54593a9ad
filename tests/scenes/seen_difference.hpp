#pragma once

// How different two colours look to a person.

#include "services/mark-detector/colour/hue.hpp"

namespace markservo::scenes {

// How far `other` looks from `one` (sRGB levels, above 0) in light in which it is as bright, since shade changes a
// thing's brightness and not its colour: the colour difference CIE94 (CIE 116-1995, graphic arts), of which 1 is just
// noticeable.
double seen_difference(const mark_detector::Bgr& one, const mark_detector::Bgr& other);

}  // namespace markservo::scenes
