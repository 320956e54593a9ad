#pragma once

// Which pixels of a box are the mark, and which are what is behind it.

#include <vector>

#include "services/mark-detector/learning/learning_pixels.hpp"

namespace markservo::mark_detector {

struct MarkShareParameters {
  double share_at_edge = 0.3;    // how likely a pixel at the box's edge is the mark's before its colour is looked at
  double share_in_middle = 0.9;  // likewise in the middle; between them with the distance
  double share_outside = 0.02;   // likewise around the box: a box that is 5 px off leaves a strip of the mark there
  int rounds = 8;                // by then shares of simulated boxes move by less than 1%
};

// Sets the pixels' mark_share. The box's pixels are a mixture of the mark's colours and of those around it, which the
// surroundings show; both distributions are histograms of chromaticity and brightness, fitted by expectation
// maximisation (Dempster, Laird and Rubin 1977). A box without surroundings is the mark by its place alone.
void set_mark_shares(std::vector<LearningPixel>& pixels, const MarkShareParameters& parameters = {});

}  // namespace markservo::mark_detector
