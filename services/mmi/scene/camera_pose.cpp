#include "services/mmi/scene/camera_pose.hpp"

namespace markservo::mmi {

Eigen::Isometry3d camera_pose(const robot::CameraDescription& cameras) {
  Eigen::Isometry3d X_RC = Eigen::Isometry3d::Identity();
  // Its columns are C's axes in R.
  X_RC.linear() << 0.0, 1.0, 0.0,  //
      -1.0, 0.0, 0.0,              //
      0.0, 0.0, 1.0;
  X_RC.translation() = cameras.p_RC;
  return X_RC;
}

}  // namespace markservo::mmi
