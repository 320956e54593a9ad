#pragma once

// Measures a mark's colour interval from pictures of it.

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct LearningParameters {
  bool equalise = true;  // as the detector does
  int chroma_min = 14;   // levels, as the detector's
  int clipped = 250;  // level; a channel from here on may be clipped, which turns the hue: left out if enough remains
  double coloured_share = 0.15;      // of the box that must have colour
  double least_saturation = 0.12;    // of the pixels' least: what is paler cannot be told from a wall
  double cluster_share = 0.5;        // of the coloured pixels that one hue must have
  double cluster_deg = 30.0;         // either way of its peak: what belongs to one hue
  double trimmed = 0.02;             // share of the pixels beyond either end: edges, dirt
  double hue_margin_deg = 8.0;       // beyond the pixels' hues
  double hue_half_width_deg = 15.0;  // at least, about their median: casts of 15% turn most hues less
  double saturation_share = 0.65;    // of the pixels' least saturation: light that clips makes pale
  double value_share = 0.4;          // of the pixels' least value: a quarter of the light after equalisation
};

// A picture and where in it the mark is, px, inside the picture.
struct LearningPicture {
  ImageView image;
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

struct LearnedColour {
  robot::ColourInterval interval;  // hue in whole degrees, saturation and value in hundredths
  std::string failure;             // why there is none; empty if there is
};

// The interval of the one hue that most coloured pixels of the boxes have; pixels count the more the nearer they are to
// their box's middle, so that background in the corners does not. Hue and saturation are the photographed pixels',
// value the equalised ones', as in the detector (colour_classifier.hpp).
LearnedColour learn_colour(const std::vector<LearningPicture>& pictures, const LearningParameters& parameters);

}  // namespace markservo::mark_detector
