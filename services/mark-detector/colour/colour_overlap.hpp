#pragma once

// Which marks a colour cannot tell apart.

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::mark_detector {

// True if some colour is in both intervals.
bool overlap(const robot::ColourInterval& a, const robot::ColourInterval& b);

// A line for each two of `marks` whose colours overlap, and what comes of it; intervals as they stand in the robot's
// file.
std::vector<std::string> told_of_overlaps(const std::vector<robot::MarkDescription>& marks);

}  // namespace markservo::mark_detector
