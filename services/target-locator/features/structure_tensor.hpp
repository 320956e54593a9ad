#pragma once

// Foerstner's interest operator (paper eq. 1, 2).

#include "services/target-locator/image/gradients.hpp"
#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

struct CornerMeasures {
  PlaneImage weight;     // W = det A / trace A, (grey levels per px)^2
  PlaneImage roundness;  // C = 4 det A / trace^2 A, 0 (edge) .. 1 (round)
  PlaneImage lines;      // room for making them
};

// W and C of A = [<g_r^2> <g_r g_c>; <g_r g_c> <g_c^2>], <> being a 5 x 5 Gaussian of sigma 1 px (paper eq. 1, 2).
// Both are 0 where trace A is below `trace_floor`: in a flat patch they would be 0 / 0.
// `measures` keeps its memory.
void foerstner(const Gradients& gradients, float trace_floor, CornerMeasures& measures);
CornerMeasures foerstner(const Gradients& gradients, float trace_floor);

}  // namespace markservo::target_locator
