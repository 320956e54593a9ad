#pragma once

#include <Eigen/Geometry>

#include "common/robot/robot_description.hpp"

namespace markservo::mmi {

// X_RC: C's y is R's x, C's x is R's -y.
Eigen::Isometry3d camera_pose(const robot::CameraDescription& cameras);

}  // namespace markservo::mmi
