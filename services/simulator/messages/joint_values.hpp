#pragma once

#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

// The joints' values as messages carry them.
inline std::vector<double> joint_values(const robot::JointVector& q) {
  return {q.data(), q.data() + q.size()};
}

}  // namespace markservo::simulator
