#pragma once

// Marks of one colour, drawn exactly, and the least error that any method can have about them.

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "tests/scenes/printed_surface.hpp"

namespace markservo::scenes {

enum class PlainForm { kSquare, kDisc, kBall, kTriangle };

struct PlainMark {
  PlainForm form = PlainForm::kSquare;
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();       // m, its centre
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns: along the width, away from the front, up
  double size = 0.0;                                   // m, edge of square and triangle, diameter of disc and ball
  cv::Vec3d colour;                                    // BGR, grey levels
  cv::Vec3d around;                                    // BGR, of what lies behind it
  double blur_px = 0.6;                                // sigma of the lens, the pixel's square not counted
};

// The lens's blur (sigma, px) where lens and pixel together blur by `total_px`, above the pixel's own sqrt(1 / 12).
double lens_blur(double total_px);

// The mark's contour as a camera sees it: a polygon, px.
std::vector<cv::Point2d> contour_of(const PlainMark& mark, const Eye& eye);

// What a camera of that size sees without noise.
cv::Mat3f picture_of(const PlainMark& mark, const Eye& eye, const cv::Size& size);

// The covariance (m^2) of the centre in C that no unbiased method can be better than (Cramer and Rao): the inverse of
// the Fisher information of both pictures' pixels, noise of `sigma` grey levels in each channel, about the centre, the
// turns that the form shows, the size, both colours and the blur.
Eigen::Matrix3d least_covariance(const PlainMark& mark, const geometry::StereoCamera& camera, double sigma);

// The same, of the disparity (px) of the centre.
double least_disparity_sigma(const PlainMark& mark, const geometry::StereoCamera& camera, double sigma);

}  // namespace markservo::scenes
