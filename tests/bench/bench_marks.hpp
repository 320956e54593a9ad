#pragma once

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::bench {

// The three marks that the benchmarks' scenes show: the robot's first flat ones of known size, the hand among them.
// `file`: named when there are fewer. Throws ConfigurationError.
std::vector<robot::MarkDescription> choose_marks(const robot::RobotDescription& robot, const std::string& file);

}  // namespace markservo::bench
