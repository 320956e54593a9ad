#pragma once

#include <Eigen/Core>

namespace markservo::target_locator {

enum class CameraSide { kLeft, kRight };

// Where one image shows a mark's centre.
struct ImageCentre {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    // px
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // px^2
};

}  // namespace markservo::target_locator
