#pragma once

// The mark's mask to the pixel that is half covered.
//
// Where a colour interval cuts the blend of mark and surroundings depends on both, so that a classified edge is off by
// up to half a pixel, and differently beside each thing. A pixel p near it is a blend of the mark's colour m and the
// neighbour's b, and covered by
//   (p - b) . (m - b) / |m - b|^2,
// with m and b the means of the pixels nearby that surely are mark and surely are not. A pixel that lies beside the
// line from b to m is no blend of the two, because another object is near: it stays as classified.

#include "services/target-locator/image/plane_image.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

struct MaskRefinementParameters {
  int band = 2;                // patch px on either side of the classified edge that may be blended
  int reach = 5;               // patch px around a blended pixel in which m and b are averaged
  double contrast_min = 20.0;  // levels between m and b; below it coverage drowns in noise
  double beside_max = 0.3;     // of the contrast, how far beside the line a blend may lie: the mark's print and noise
};

// The pixels that are half covered or more. Work grows with the edge's length: for marks of which something is hidden.
Mask half_covered(const Patch& patch, const Mask& mask, const MaskRefinementParameters& parameters);

}  // namespace markservo::target_locator
