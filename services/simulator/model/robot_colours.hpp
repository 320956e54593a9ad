#pragma once

#include <Eigen/Core>

namespace markservo::simulator {

// What the robot is made of, red, green and blue, each 0..1.
inline const Eigen::Vector3d kMetal(0.62, 0.64, 0.66);
inline const Eigen::Vector3d kDark(0.16, 0.16, 0.17);

}  // namespace markservo::simulator
