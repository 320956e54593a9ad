#pragma once

// How true the locator's matches are, beside what the noise allows and beside OpenCV's optical flow.

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::bench {

struct AccuracyParameters {
  int num_matches = 800;   // of a case, at least: the rms is then known to 3%
  double slant = 0.12;     // px of disparity per px along the rows, of the slanted case
  double sigma = 3.0;      // grey levels of noise in each channel, and rounding to whole levels after it
  double blur_px = 0.6;    // sigma of the lens
  bool even_print = true;  // as the simulator's marks are printed; else mostly values in between: less texture
  unsigned seed = 1;
};

// Errors of disparity over the matches of one case, px.
struct MatchErrors {
  int matches = 0;
  int marks = 0;      // drawn
  int unlocated = 0;  // of these
  double mean = 0.0;  // of the absolute error
  double p95 = 0.0;   // likewise
  double rms = 0.0;
  double crlb = 0.0;           // root mean square of the matches' own Cramer-Rao bounds
  double converged_rms = 0.0;  // of the same windows' own estimates, iterated until they settle
  double normalised = 0.0;     // root mean square of error over own bound: 1 is what noise allows
  double plane_rms = 0.0;      // of the disparity at the mark's centre that the published position says
  double plane_crlb = 0.0;     // root mean square of the bound of a plane fitted to all of the mark's pixels
  int flow_matches = 0;        // of the matches, where PyrLK succeeded
  double flow_mean = 0.0;      // of PyrLK there
  double flow_rms = 0.0;
  double rms_where_flow = 0.0;  // of ours there
};

struct Accuracy {
  MatchErrors fronto;
  MatchErrors slanted;

  // The worse of the two cases, and of the published matches and their windows' own estimates.
  double rms_over_crlb() const;
  double rms_over_flow_slanted() const { return slanted.rms_where_flow / slanted.flow_rms; }
};

// Draws marks with textures and places of their own, square to the cameras and slanted, and runs the detector and the
// locator as they come by default on both. A match is one window's estimate of the disparity, the slope being the
// mark's plane's: one step from where the plane is, so that it keeps a little of what all pixels say and may lie below
// the bound of its window, which the estimate that is iterated until it settles cannot. The bound is that of the
// disparity in that window with gain and offset unknown and noise in both images: 2 sigma^2 / sum of squared gradients,
// the gradients without noise, of the colours' projection that the locator looks at, less what gain and offset explain
// of them. PyrLK works on luma with a window of 11 px and the true disparity to a whole pixel as its start.
Accuracy measure_accuracy(const robot::RobotDescription& robot, const std::vector<robot::MarkDescription>& marks,
                          const AccuracyParameters& parameters);

}  // namespace markservo::bench
