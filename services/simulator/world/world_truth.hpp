#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/marks/marks.hpp"
#include "services/simulator/scene/books.hpp"

namespace markservo::simulator {

// What is true about arm, books and marks, in C.
struct WorldTruth {
  robot::JointVector shaft = robot::JointVector::Zero();  // rad, where the joints really are
  Eigen::Vector3d p_CG = Eigen::Vector3d::Zero();         // m
  double gripper_opening = 0.0;                           // m
  bool arm_touched = false;                               // anything, since the reset
  std::string touched;                                    // the first such pair
  std::vector<BodyTruth> bodies;
  std::vector<MarkTruth> marks;  // in robot.yaml's order
};

}  // namespace markservo::simulator
