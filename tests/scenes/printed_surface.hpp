#pragma once

// Printed rectangles in space and how a camera of the stereo pair sees them: sampled many times a pixel and averaged by
// area, so that no interpolation takes part in making the pictures.

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "common/geometry/stereo_camera.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::scenes {

// A rectangle in space with a print on it that varies along its colour, as ink of one colour does.
struct Surface {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();    // m, in C
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: along the width, away from the front, up
  double width = 0.0;                                  // m
  double height = 0.0;                                 // m
  cv::Vec3f colour;                                    // BGR, brightest
  double cell = 0.001;                                 // m, of the print
  double depth = 0.0;                                  // share of the brightness that the print varies by
  bool even = false;  // the print takes all values between its extremes alike, else mostly those between
  unsigned seed = 0;  // of the print

  // Where the line of sight from `origin` along `direction` meets the surface's plane: x and z along its axes, m.
  Eigen::Vector2d meet(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;
  bool holds(const Eigen::Vector2d& place) const;
  // u_left - u_right of the surface's plane at a place of the left image, px: a plane's disparity is linear.
  double disparity(const geometry::StereoCamera& camera, double u, double v) const;
};

// BGR of a hue (degrees), saturation and value (0 to 1).
cv::Vec3f bgr(double hue_deg, double saturation, double value);

// A colour well within the interval.
cv::Vec3f mark_colour(const robot::ColourInterval& interval);

// The point at `depth` (m) that the left image shows at (u, v).
Eigen::Vector3d point_at(const geometry::StereoCamera& camera, double u, double v, double depth);

// One of the pair's cameras.
struct Eye {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // m, in C
  double fx = 0.0;                                   // px
  double fy = 0.0;                                   // px
  double cx = 0.0;                                   // px
  double cy = 0.0;                                   // px

  Eye(const geometry::StereoCamera& camera, bool right);
  Eigen::Vector3d direction(double u, double v) const { return {(u - cx) / fx, 1.0, -(v - cy) / fy}; }
  // Of a point in front of it.
  cv::Point2d image_of(const Eigen::Vector3d& p_C) const;
};

// The bounding box of the surface's image, px.
cv::Rect2d box_of(const Surface& surface, const Eye& eye);

// Paints the surface over `samples`: num_samples x num_samples a pixel, of the image's pixels from `corner` on.
void paint(const Surface& surface, const Eye& eye, const cv::Point& corner, int num_samples, cv::Mat3f& samples);

// 8-bit with noise of `sigma` grey levels in each channel.
cv::Mat expose(const cv::Mat3f& view, double sigma, cv::RNG& random);

}  // namespace markservo::scenes
