#pragma once

#include <Eigen/Core>
#include <cmath>

namespace markservo::simulator {

// A pose on the floor, X_WR: the robot R in the tag field's frame W.
struct PlanarPose {
  double x = 0.0;        // m
  double y = 0.0;        // m
  double heading = 0.0;  // rad, of R's x axis, counter-clockwise from above; not wrapped

  // p_WQ of a point fixed to the robot, m.
  Eigen::Vector2d operator*(const Eigen::Vector2d& p_RQ) const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return {x + c * p_RQ.x() - s * p_RQ.y(), y + s * p_RQ.x() + c * p_RQ.y()};
  }
};

// The same from a heading in degrees, as files and settings have it.
inline PlanarPose pose_from_degrees(double x, double y, double heading_deg) {
  return {x, y, heading_deg * M_PI / 180.0};
}

}  // namespace markservo::simulator
