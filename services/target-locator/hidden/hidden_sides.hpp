#pragma once

// The centre of a square of known size of which something nearer hides a part.
//
// What both views show of the mark is laid onto its plane in space. The square must hold all of it, so that along each
// of its two axes either both its sides are seen, one size apart, or some of it is missing, and then it must be told
// which of the two outermost edges is a side of the square and which is the edge of what hides it. A side is straight
// and parallel to the square, and both cameras see it at the same place of the plane, where they see the edge of
// something nearer at different places. Where this does not decide, the centre lies between the possible ones and its
// covariance spans them.

#include <optional>

#include "services/target-locator/centre/mark_centre.hpp"
#include "services/target-locator/image/stereo_patch.hpp"

namespace markservo::target_locator {

struct HiddenSidesParameters {
  double edge_floor_px = 0.04;    // patch px, sigma of a side of which the masks' pixels tell nothing more
  double two_things = 0.02;       // how often two things hide opposite sides, beside one that hides one
  double size_sigma = 0.003;      // relative, of the size given
  double size_tolerance = 0.012;  // relative: both sides are seen when they are one size apart to this
  double most_too_large = 0.05;   // relative: what exceeds the square by more is none of it
  double least_gap = 0.010;       // m, what hides is at least this much nearer than the mark
  double crooked_rad = 0.012;     // an edge turned by more against the square is none of its sides
  double least_length = 0.12;     // of the size: a shorter edge may be a tip of anything
  double unlikely = 0.03;         // a possibility less likely than this is none
};

// One camera's view of the mark.
struct MaskedView {
  const Mask& mask;
  const PatchFrame& frame;
};

// Where the left image shows the centre of the square of edge `size` (m, above 0), with what is not known of it in the
// covariance. `row_offset` (px) is what the right view lies lower than its rows say. Nothing when the masks hold too
// little or more than such a square, or the plane is not in front of the cameras.
std::optional<ImageCentre> centre_of_hidden_square(const MaskedView& left, const MaskedView& right,
                                                   const DisparityPlane& plane, double row_offset,
                                                   const geometry::StereoCamera& camera, double size,
                                                   const HiddenSidesParameters& parameters);

}  // namespace markservo::target_locator
