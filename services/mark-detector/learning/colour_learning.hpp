#pragma once

// Measures a mark's colour interval from pictures of it.

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/learning/interval_fit.hpp"
#include "services/mark-detector/learning/learning_picture.hpp"
#include "services/mark-detector/learning/learning_pixels.hpp"
#include "services/mark-detector/learning/mark_share.hpp"

namespace markservo::mark_detector {

struct LearningParameters {
  bool equalise = true;  // as the detector does
  int chroma_min = 14;   // levels, as the detector's
  int clipped = 250;  // level; a channel from here on may be clipped, which turns the hue: left out if enough remains
  double coloured_share = 0.15;      // of the box that must have colour
  double least_saturation = 0.12;    // of the body's least: what is paler cannot be told from a wall
  double cluster_share = 0.5;        // of the coloured pixels that one hue must have
  double cluster_deg = 30.0;         // either way of its peak: what belongs to one hue
  double glossy_share = 0.15;        // of a pixel's light that is reflected at the surface: a highlight or its rim
  double trimmed = 0.02;             // share of the pixels beyond either end: edges, dirt
  double hue_margin_deg = 8.0;       // beyond the pixels' hues
  double hue_half_width_deg = 15.0;  // at least, about their median: casts of 15% turn most hues less
  double saturation_share = 0.65;    // of the pixels' least saturation: light that clips makes pale
  double value_share = 0.4;          // of the pixels' least value: a quarter of the light after equalisation
  double kept = 0.7;                 // of the body's pixels that one limit must leave, whatever is around the mark
  LearningPixelParameters pixels;
  MarkShareParameters shares;
  IntervalFitParameters fit;
};

struct LearnedColour {
  robot::ColourInterval interval;  // hue in whole degrees, saturation and value in hundredths
  std::vector<double> mark_px2;    // of each picture, the part of its box that is the mark by colour and place
  std::string doubt;               // why it may not serve, for a person; empty if nothing speaks against it
  std::string failure;             // why there is none; empty if there is
};

// The interval of the one hue that most coloured pixels of the boxes have, apart from what is around the boxes. Pixels
// count the more the nearer they are to their box's middle and the less their colours are those around it.
//
// Light that a surface reflects is that of its body, whose chromaticity shade leaves as it is, and that of its gloss,
// which has the lamp's colour (Shafer 1985, "Using color to separate reflection components"): highlights and their rims
// are brighter and paler than the body, and say nothing of its colour. Around the body's hues, saturations and values
// the interval has margins for other light, as far as what is around the mark leaves them.
//
// Hue and saturation are the photographed pixels', value the equalised ones', as in the detector
// (colour_classifier.hpp).
LearnedColour learn_colour(const std::vector<LearningPicture>& pictures, const LearningParameters& parameters);

}  // namespace markservo::mark_detector
