#pragma once

// Whether a colour finds the mark in the picture that it was learned from.

#include <cstddef>
#include <string>

#include "services/mark-detector/learning/learning_picture.hpp"
#include "services/mark-detector/mark_detector.hpp"

namespace markservo::mark_detector {

struct LearningCheckParameters {
  double margin_share = 0.1;    // of the box's edge: how far beyond the box a mark may reach that a hand has boxed
  int margin_least = 6;         // px
  double outgrown_share = 0.1;  // of what is found that may lie further out
  double rim_share = 0.5;       // of that margin that may be found: a square that is boxed 5 px off fills less than 0.4
  double covered_share = 0.6;   // of what is the mark in the box that must be found
};

// What is wrong with what the detector finds of its mark number `mark` in the picture, for a person: nothing, something
// elsewhere, more than the box, or too little of the `mark_px2` that are the mark's there. Empty if it finds the mark
// in its box.
std::string doubt_about_learning(const MarkDetector& detector, std::size_t mark, const LearningPicture& picture,
                                 double mark_px2, const LearningCheckParameters& parameters = {});

}  // namespace markservo::mark_detector
