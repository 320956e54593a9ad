#pragma once

#include <Eigen/Core>

namespace markservo::simulator {

struct Ray {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();     // m
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // unit vector
};

}  // namespace markservo::simulator
