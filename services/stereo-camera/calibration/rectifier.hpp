#pragma once

// Undistorts and rectifies the pictures of a stereo pair, so that the rows of both are epipolar lines.

#include <opencv2/core.hpp>

#include "services/stereo-camera/calibration/stereo_calibration.hpp"

namespace markservo::stereo_camera {

// How much the rectified picture and the camera's have in common, for the worse of both sides.
struct SharedView {
  double filled = 1.0;  // share of the rectified picture that shows something; the rest is black
  double kept = 1.0;    // share of the camera's picture that the rectified one shows
};

class Rectifier {
 public:
  // `calibration` is rectified; computes the maps for pictures of `size`. Throws ConfigurationError where what comes
  // out is no view of these cameras: a rectified camera outside geometry::implausibility()'s bounds, rows that do not
  // agree, less than kMinFilled of the rectified picture filled or less than kMinKept of the camera's kept.
  Rectifier(const StereoCalibration& calibration, cv::Size size);

  const SharedView& shared_view() const { return shared_view_; }

  // BGR images of the constructor's size; throws std::invalid_argument for another.
  void rectify(const cv::Mat& left_raw, const cv::Mat& right_raw, cv::Mat& left, cv::Mat& right) const;

  static constexpr double kMinFilled = 0.5;
  static constexpr double kMinKept = 0.15;        // of a fisheye's half circle a flat picture keeps a quarter
  static constexpr double kMaxRowError_px = 0.5;  // as of a calibration's own error

 private:
  struct Maps {
    cv::Mat integer;   // CV_16SC2
    cv::Mat fraction;  // CV_16UC1
  };
  Maps make_maps(const CameraCalibration& camera, Lens lens);

  cv::Size size_;
  SharedView shared_view_;
  Maps left_;
  Maps right_;
};

}  // namespace markservo::stereo_camera
