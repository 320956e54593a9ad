#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace markservo::task_manager {

// A box anywhere in C.
struct Box {
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();  // its middle and axes
  Eigen::Vector3d half_size = Eigen::Vector3d::Zero();     // m
};

// How far apart two boxes are at least, m: the widest gap along any separating axis, which never exceeds their
// distance. Negative when they overlap (Gottschalk et al., OBBTree, SIGGRAPH 1996).
double box_clearance(const Box& a, const Box& b);

}  // namespace markservo::task_manager
