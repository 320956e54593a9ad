#include "services/stereo-camera/calibration/rectifier.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "common/geometry/camera_bounds.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/rectification.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr int kCell_px = 8;             // in which the shown part of the camera's picture is added up
constexpr float kNowhere_px = -100.0F;  // outside every picture

[[noreturn]] void refuse(const StereoCalibration& calibration, const std::string& what) {
  throw ConfigurationError(calibration.path + ": " + what);
}

void require_plausible(const StereoCalibration& calibration, cv::Size size) {
  const std::string why = geometry::implausibility(rectified_camera(calibration), size.width, size.height);
  if (!why.empty()) {
    refuse(calibration, fmt::format("of the rectified {} x {} px pictures {} (is the lens model right?)", size.width,
                                    size.height, why));
  }
  const double rows_px = row_error_px(calibration, size);
  if (rows_px > Rectifier::kMaxRowError_px) {
    refuse(calibration, fmt::format("R1, R2, P1 and P2 put one point on rows {:.3g} px apart, by its R and T; allowed: "
                                    "up to {:.3g} px (are they of one calibration?)",
                                    rows_px, Rectifier::kMaxRowError_px));
  }
}

// Marks what the lens's model does not reach: directions behind the camera, and beyond its fold.
void erase_invalid(const CameraCalibration& camera, Lens lens, cv::Mat& map_u) {
  const double radius = radius_of_validity(camera.D, lens);
  const cv::Matx33d from_px = camera.R.t() * camera.P.get_minor<3, 3>(0, 0).inv();
  for (int v = 0; v < map_u.rows; ++v) {
    auto* row = map_u.ptr<float>(v);
    for (int u = 0; u < map_u.cols; ++u) {
      const cv::Vec3d ray = from_px * cv::Vec3d(u, v, 1.0);
      if (!(ray[2] > 0.0) || std::hypot(ray[0], ray[1]) > radius * ray[2]) row[u] = kNowhere_px;
    }
  }
}

class RawPicture {
 public:
  explicit RawPicture(cv::Size size) : size_(size) {}

  // To half a pixel, as far as its outermost pixels reach.
  bool holds(cv::Point2f p) const {
    return p.x >= -0.5F && p.y >= -0.5F && p.x <= static_cast<float>(size_.width) - 0.5F &&
           p.y <= static_cast<float>(size_.height) - 0.5F;
  }

  SharedView shared(const cv::Mat& map_u, const cv::Mat& map_v) const {
    const auto at = [&](int u, int v) { return cv::Point2f(map_u.at<float>(v, u), map_v.at<float>(v, u)); };
    std::int64_t filled = 0;
    for (int v = 0; v < map_u.rows; ++v) {
      for (int u = 0; u < map_u.cols; ++u) filled += holds(at(u, v)) ? 1 : 0;
    }
    double kept_px = 0.0;
    for (int v = 0; v + 1 < map_u.rows; v += kCell_px) {
      const int below = std::min(v + kCell_px, map_u.rows - 1);
      for (int u = 0; u + 1 < map_u.cols; u += kCell_px) {
        const int beside = std::min(u + kCell_px, map_u.cols - 1);
        const cv::Point2f corners[] = {at(u, v), at(beside, v), at(beside, below), at(u, below)};
        if (std::all_of(std::begin(corners), std::end(corners), [&](cv::Point2f p) { return holds(p); })) {
          const cv::Point2f across = corners[2] - corners[0];
          const cv::Point2f along = corners[3] - corners[1];
          kept_px += 0.5 * std::abs(across.x * along.y - across.y * along.x);
        }
      }
    }
    const double between_px =
        std::max(1, (size_.width - 1) * (size_.height - 1));  // as the corners of cells are counted
    return {static_cast<double>(filled) / static_cast<double>(map_u.total()), std::min(1.0, kept_px / between_px)};
  }

 private:
  cv::Size size_;
};

void require_shared(const StereoCalibration& calibration, const SharedView& view, cv::Size size) {
  const auto require = [&](double share, double least, const char* what) {
    if (share >= least) return;
    refuse(calibration,
           fmt::format("only {:.1f}% of {}; allowed: {:.0f}% or more (was it made for another camera, lens "
                       "model or image size than {} x {} px?)",
                       100.0 * share, what, 100.0 * least, size.width, size.height));
  };
  require(view.filled, Rectifier::kMinFilled, "a rectified picture shows anything");
  require(view.kept, Rectifier::kMinKept, "a camera's picture is left in the rectified one");
}

}  // namespace

Rectifier::Rectifier(const StereoCalibration& calibration, cv::Size size) : size_(size) {
  if (size.width < 1 || size.height < 1) throw std::invalid_argument("Rectifier: size must be 1 x 1 px or more");
  if (!calibration.rectified) throw std::invalid_argument("Rectifier: calibration is not rectified");
  require_plausible(calibration, size);
  left_ = make_maps(calibration.left, calibration.lens);
  right_ = make_maps(calibration.right, calibration.lens);
  require_shared(calibration, shared_view_, size);
}

Rectifier::Maps Rectifier::make_maps(const CameraCalibration& camera, Lens lens) {
  cv::Mat map_u;
  cv::Mat map_v;
  if (lens == Lens::kFisheye) {
    cv::fisheye::initUndistortRectifyMap(camera.K, camera.D, camera.R, camera.P, size_, CV_32FC1, map_u, map_v);
  } else {
    cv::initUndistortRectifyMap(camera.K, camera.D, camera.R, camera.P, size_, CV_32FC1, map_u, map_v);
  }
  erase_invalid(camera, lens, map_u);
  const SharedView view = RawPicture(size_).shared(map_u, map_v);
  shared_view_.filled = std::min(shared_view_.filled, view.filled);
  shared_view_.kept = std::min(shared_view_.kept, view.kept);
  Maps maps;
  cv::convertMaps(map_u, map_v, maps.integer, maps.fraction, CV_16SC2);
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
