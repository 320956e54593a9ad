#pragma once

// What a mark's colour is by its description, and what is known of it in the light of the moment.

#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/colour/hue.hpp"

namespace markservo::mark_detector {

// A mark's colour as the robot's description has it.
struct NominalColour {
  robot::ColourInterval interval;
  double low = 0.0;         // degrees, [0, 360)
  double high = 0.0;        // degrees, above low
  bool fixed = false;       // every hue: never adapted
  bool shares_hue = false;  // with another mark: told apart by saturation or value, which then stay
  Bgr colour{};             // levels, in the middle
};

// The nominal colour of each mark, in their order.
std::vector<NominalColour> nominal_colours(const std::vector<robot::MarkDescription>& marks);

// What is known of one mark's colour.
struct MarkColour {
  bool known = false;    // seen within the memory
  int age = 0;           // frames since it was seen
  bool certain = false;  // the light's change could be told in all of them
  Bgr mean{};            // levels as the camera would show them if it did not clip
  double spread = 0.0;   // standard deviation of the print's brightness, share of the mean

  bool sure() const { return known && certain; }
};

}  // namespace markservo::mark_detector
