#include "services/stereo-camera/calibration/rectifier.hpp"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {
namespace {

double share_inside(const cv::Mat& map, cv::Size size) {
  cv::Mat inside;
  cv::inRange(map, cv::Scalar(0.0, 0.0), cv::Scalar(size.width - 1.0, size.height - 1.0), inside);
  return static_cast<double>(cv::countNonZero(inside)) / static_cast<double>(map.total());
}

// A calibration for another image size shows by its principal point.
void require_middle(const CameraCalibration& camera, const std::string& key, cv::Size size) {
  const double u = camera.K(0, 2) / size.width;
  const double v = camera.K(1, 2) / size.height;
  const auto near_middle = [](double share) { return share > 0.25 && share < 0.75; };
  if (near_middle(u) && near_middle(v)) return;
  throw ConfigurationError("stereo calibration: key '" + key + "' has its principal point at (" +
                           std::to_string(camera.K(0, 2)) + ", " + std::to_string(camera.K(1, 2)) +
                           ") px; allowed: in the middle half of the " + size_text(size) +
                           " picture (was it made for another size?)");
}

}  // namespace

Rectifier::Rectifier(const StereoCalibration& calibration, cv::Size size) : size_(size) {
  if (size.width < 1 || size.height < 1) throw std::invalid_argument("Rectifier: size must be 1 x 1 px or more");
  require_middle(calibration.left, "K1", size);
  require_middle(calibration.right, "K2", size);
  left_ = make_maps(calibration.left);
  right_ = make_maps(calibration.right);
  if (coverage_ < kMinCoverage) {
    throw ConfigurationError("stereo calibration: only " + std::to_string(static_cast<int>(100.0 * coverage_)) +
                             "% of a rectified image lies inside the " + std::to_string(size.width) + " x " +
                             std::to_string(size.height) +
                             " px picture; allowed: " + std::to_string(static_cast<int>(100.0 * kMinCoverage)) +
                             "% or more (was it made for another camera or image size?)");
  }
}

Rectifier::Maps Rectifier::make_maps(const CameraCalibration& camera) {
  Maps maps;
  cv::initUndistortRectifyMap(camera.K, camera.D, camera.R, camera.P, size_, CV_16SC2, maps.integer, maps.fraction);
  coverage_ = std::min(coverage_, share_inside(maps.integer, size_));
  return maps;
}

void Rectifier::rectify(const cv::Mat& left_raw, const cv::Mat& right_raw, cv::Mat& left, cv::Mat& right) const {
  if (left_raw.size() != size_ || right_raw.size() != size_) {
    throw std::invalid_argument("Rectifier: images are not of the calibrated size");
  }
  cv::remap(left_raw, left, left_.integer, left_.fraction, cv::INTER_LINEAR);
  cv::remap(right_raw, right, right_.integer, right_.fraction, cv::INTER_LINEAR);
}

}  // namespace markservo::stereo_camera
