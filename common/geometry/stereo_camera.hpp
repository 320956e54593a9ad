#pragma once

// A rectified stereo pair and its camera frame C: origin in the left lens, x right, y forward (depth), z up.
// Images: u right, v down, pixel centres at integers; a point has the same row v in both.

#include <Eigen/Core>
#include <optional>

namespace markservo::geometry {

// Where a point appears in both images, px.
struct StereoPoint {
  double u_left = 0.0;
  double v = 0.0;
  double u_right = 0.0;
};

struct StereoCamera {
  double fx = 0.0;        // px, above 0
  double fy = 0.0;        // px, above 0
  double cx_left = 0.0;   // px
  double cx_right = 0.0;  // px
  double cy = 0.0;        // px
  double baseline = 0.0;  // m, above 0

  // u_left - u_right of a point at infinity subtracted: fx * baseline / depth, px.
  double disparity(const StereoPoint& point) const { return (point.u_left - cx_left) - (point.u_right - cx_right); }
};

// The images of `p_C` (m); nothing for a point that is not in front of the lenses (y <= 0).
std::optional<StereoPoint> project(const StereoCamera& camera, const Eigen::Vector3d& p_C);

// The point seen at `point`, m in C (paper eq. 5 with depth positive in front); nothing where the disparity is not
// positive.
std::optional<Eigen::Vector3d> triangulate(const StereoCamera& camera, const StereoPoint& point);

// d p_C / d (u_left, v, disparity), m/px, at a point with positive disparity: maps image covariances to space.
// Throws std::invalid_argument elsewhere.
Eigen::Matrix3d triangulation_jacobian(const StereoCamera& camera, const StereoPoint& point);

}  // namespace markservo::geometry
