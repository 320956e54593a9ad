#pragma once

// Lucas-Kanade along the epipolar line: one feature's disparity to a few hundredths of a pixel (B. D. Lucas and T.
// Kanade, "An iterative image registration technique with an application to stereo vision", IJCAI 1981).

#include <optional>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/stereo_patch.hpp"

namespace markservo::target_locator {

struct RefinementParameters {
  int half_window = 7;        // patch px, at most 7; 15 x 15 fill vectors of 16
  bool solve_slopes = false;  // disparity's slopes as well (needs 15 x 15)
  int max_iterations = 6;
  double settled_px = 0.005;
  double max_change_px = 1.5;    // image px from the start; farther is another point
  double min_correlation = 0.6;  // of the two windows after refinement
};

// Disparity at a feature and how it changes around it.
struct LocalDisparity {
  double disparity = 0.0;  // px of the image, u_left - u_right
  double along_u = 0.0;    // px per px
  double along_v = 0.0;    // px per px
};

struct RefinedMatch {
  LocalDisparity local;
  double sigma = 0.0;        // px, of the disparity
  double correlation = 0.0;  // of the windows
};

// The disparity near `start` that makes the windows equal up to gain and offset. The window leaves out pixels where
// `support` is 0 when it is given. Nothing when a window leaves its patch, has no texture, runs away or does not fit.
std::optional<RefinedMatch> refine_match(const StereoPatch& patch, const Feature& feature, const LocalDisparity& start,
                                         const Mask* support, const RefinementParameters& parameters);

}  // namespace markservo::target_locator
