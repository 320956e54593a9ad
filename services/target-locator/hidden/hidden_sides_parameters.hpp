#pragma once

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

}  // namespace markservo::target_locator
