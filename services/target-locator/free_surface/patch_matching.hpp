#pragma once

// Where to begin: the whole-pixel disparity of a feature whose depth is not known.

#include <optional>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/stereo_patch.hpp"

namespace markservo::target_locator {

struct SearchParameters {
  double disparity_min = 0.0;  // px of the image
  double disparity_max = 0.0;  // px of the image
  int half_window = 5;         // patch px
  double min_correlation = 0.7;
  double uniqueness = 0.06;       // the best correlation stands this far above every other peak's
  double max_disagreement = 1.0;  // right patch px, between searching left in right and right in left
  double colour_sigma = 12.0;     // grey levels: pixels this different from the feature count 0.6 as much
};

// The disparity (px of the image) at which the feature's window correlates best along its row, its peak's parabola
// included. Pixels of the window weigh less the more their grey differs from the feature's, so that a window across a
// depth edge follows the feature's side. Nothing when the window is flat or leaves the patch, when no peak is high
// enough or two are alike, or when the right point's own best partner is another one (left-right check).
std::optional<double> search_match(const StereoPatch& patch, const Feature& feature,
                                   const SearchParameters& parameters);

}  // namespace markservo::target_locator
