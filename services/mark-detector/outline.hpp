#pragma once

// The mark's outline to a fraction of a pixel.
//
// Where a colour interval cuts the blend of mark and background depends on both, so a classified edge is off by up to a
// quarter of a pixel, and differently against each background. Near the outline a pixel p is a blend of the mark's
// colour m and the background's b; its coverage is
//   alpha = (p - b) . (m - b) / |m - b|^2, within [0, 1],
// with m and b the means of the surely covered and surely free pixels nearby. A pixel that lies beside the line from b
// to m is no blend of the two, because another object is near: it stays as classified.

#include <vector>

#include "services/mark-detector/blobs.hpp"
#include "services/mark-detector/image_view.hpp"
#include "services/mark-detector/region.hpp"

namespace markservo::mark_detector {

struct OutlineParameters {
  int band = 2;              // px on either side of the classified edge that may be blended (blur and antialiasing)
  int reach = 5;             // px around a blended pixel in which m and b are averaged; above twice the band
  double contrast_min = 20;  // levels between m and b; below it coverage drowns in noise and the classification stays
  double beside_max = 0.3;   // of the contrast, how far beside the line a blend may lie: the mark's print and noise
};

struct OutlinedMark {
  Shape shape;    // of the coverage: area, centroid and moments weighted by it, the box around coverage of a half
  Region region;  // mask: coverage of a half or more
};

// Coverage of the mark that `runs` classify, whose holes are filled. `runs` must not be empty.
OutlinedMark outline(const ImageView& image, const std::vector<PixelRun>& runs, const OutlineParameters& parameters);

// The same without looking at the image: every pixel is covered or free.
OutlinedMark hard_outline(const std::vector<PixelRun>& runs, int image_width, int image_height);

}  // namespace markservo::mark_detector
