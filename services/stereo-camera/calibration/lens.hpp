#pragma once

// How a lens bends what it sees.

#include <opencv2/core.hpp>
#include <string>

namespace markservo::stereo_camera {

enum class Lens {
  kPinhole,  // OpenCV's calib3d model: 4, 5, 8, 12 or 14 coefficients
  kFisheye,  // OpenCV's fisheye model (Kannala and Brandt): 4 coefficients
};

// Of a file that does not say which model its four coefficients belong to.
std::string four_coefficients_warning(const std::string& path, const std::string& key);

// Up to which distance from the optical axis, as the tangent of the ray's angle with it, the model sends rays of
// growing angle further out. Beyond, it folds: two directions share a pixel, and undistortion has no answer. Judged by
// the radial part alone; up to 80 degrees, where a flat picture ends to be of use. `D` as the lens takes it, 1 x n.
double radius_of_validity(const cv::Mat& D, Lens lens);

}  // namespace markservo::stereo_camera
