#pragma once

// Undistorts and rectifies the pictures of a stereo pair, so that the rows of both are epipolar lines.

#include <opencv2/core.hpp>

#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

class Rectifier {
 public:
  // Computes the maps for images of `size`. Throws ConfigurationError where the calibration belongs to another size or
  // camera: a principal point far from the middle, or less than `kMinCoverage` of a rectified image that shows
  // anything.
  Rectifier(const StereoCalibration& calibration, cv::Size size);

  // The share of the rectified image that has a place in the raw one, for the worse of both sides.
  double coverage() const { return coverage_; }

  // BGR images of the constructor's size; throws std::invalid_argument for another.
  void rectify(const cv::Mat& left_raw, const cv::Mat& right_raw, cv::Mat& left, cv::Mat& right) const;

  static constexpr double kMinCoverage = 0.5;

 private:
  struct Maps {
    cv::Mat integer;   // CV_16SC2
    cv::Mat fraction;  // CV_16UC1
  };
  Maps make_maps(const CameraCalibration& camera);

  cv::Size size_;
  double coverage_ = 1.0;
  Maps left_;
  Maps right_;
};

}  // namespace markservo::stereo_camera
