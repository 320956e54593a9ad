#pragma once

// The scene frame S: the camera frame C of the robot that stands at the scene's dock, D in the tag field's frame W.
// MuJoCo's world frame is S, so that a scene file tells places as the docked robot's cameras see them.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::simulator {

class SceneFrame {
 public:
  // `X_WD` as the scene has it, `p_RC` (m) as the robot has it: C's x is R's -y, C's y is R's x.
  SceneFrame(const geometry::PlanePose& X_WD, const Eigen::Vector3d& p_RC) : X_WD_(X_WD), p_RC_(p_RC.head<2>()) {}

  // p_SQ of a place p_WQ on the floor, m.
  Eigen::Vector2d place(const Eigen::Vector2d& p_WQ) const { return in_camera_axes(docked(p_WQ)); }

  // X_SC of the robot at `X_WR`: C's origin on the floor, and its turn against S. Exactly zero at the dock.
  geometry::PlanePose camera(const geometry::PlanePose& X_WR) const {
    const double turn = X_WR.heading - X_WD_.heading;
    const Eigen::Vector2d p_DC = docked({X_WR.x, X_WR.y}) + Eigen::Rotation2Dd(turn) * p_RC_;
    const Eigen::Vector2d p_SC = in_camera_axes(p_DC);
    return {p_SC.x(), p_SC.y(), turn};
  }

  // rad, the direction of R's x axis in S when the robot is at `X_WR`.
  double forward(const geometry::PlanePose& X_WR) const { return X_WR.heading - X_WD_.heading + 0.5 * M_PI; }

  // p_CQ of a point fixed to the robot, m, without height.
  Eigen::Vector2d in_camera(const Eigen::Vector2d& p_RQ) const { return in_camera_axes(p_RQ); }

 private:
  // A place in the docked robot's frame.
  Eigen::Vector2d docked(const Eigen::Vector2d& p_WQ) const {
    return Eigen::Rotation2Dd(-X_WD_.heading) * (p_WQ - Eigen::Vector2d(X_WD_.x, X_WD_.y));
  }
  Eigen::Vector2d in_camera_axes(const Eigen::Vector2d& p_RQ) const {
    return {p_RC_.y() - p_RQ.y(), p_RQ.x() - p_RC_.x()};
  }

  geometry::PlanePose X_WD_;
  Eigen::Vector2d p_RC_;
};

}  // namespace markservo::simulator
