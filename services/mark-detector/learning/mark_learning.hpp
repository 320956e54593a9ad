#pragma once

// Learns a mark's colour from pictures of it and tells what speaks against it: what --learn and LEARN_REQUEST share.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/learning/colour_learning.hpp"
#include "services/mark-detector/learning/learning_picture.hpp"
#include "services/mark-detector/mark_detector.hpp"

namespace markservo::mark_detector {

// How a picture shows the mark to a detector with the learned colour.
struct LearnedView {
  std::string doubt;  // why the colour may not serve there; empty if nothing speaks against it
  Region found;       // where the mark is found; empty if it is not
};

struct OverlappingMark {
  std::string name;
  std::string text;  // what comes of it, for a person
};

struct MarkLearning {
  LearnedColour colour;            // where it has a failure, the rest is empty
  std::vector<LearnedView> views;  // one a picture
  std::vector<OverlappingMark> overlaps;
};

// The colour of mark number `mark` of `marks`, with the others as they are. The boxes lie within their pictures. Throws
// std::invalid_argument if the detector's parameters are out of range, std::out_of_range if there is no such mark.
MarkLearning learn_mark(std::vector<robot::MarkDescription> marks, std::size_t mark,
                        const std::vector<LearningPicture>& pictures, const LearningParameters& learning,
                        const Parameters& detection);

// Which pixels of a picture's box are the mark by what was found there.
struct BoxMask {
  std::vector<std::uint8_t> bits;  // one a px of the box, rows padded to whole bytes, lowest bit first
  double covered = 0.0;            // [0, 1], share of the box
};

BoxMask mask_over_box(const Region& found, const LearningPicture& picture);

}  // namespace markservo::mark_detector
