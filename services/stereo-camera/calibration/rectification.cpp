#include "services/stereo-camera/calibration/rectification.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <stdexcept>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMaxZoom = 2.0;         // either way; a fisheye's flat view has 0.76, cameras turned inwards up to 1.5
constexpr double kNearestShare = 0.125;  // disparity of the nearest point, of the picture's width

// By a pinhole without distortion where `distorted` is not set.
void rectify(StereoCalibration& calibration, cv::Size size, bool distorted) {
  CameraCalibration& left = calibration.left;
  CameraCalibration& right = calibration.right;
  const cv::Mat R(calibration.relative->R);
  const cv::Mat T(calibration.relative->T);
  cv::Mat R1;
  cv::Mat R2;
  cv::Mat P1;
  cv::Mat P2;
  cv::Mat Q;
  if (distorted && calibration.lens == Lens::kFisheye) {
    cv::fisheye::stereoRectify(left.K, left.D, right.K, right.D, size, R, T, R1, R2, P1, P2, Q,
                               cv::CALIB_ZERO_DISPARITY);
  } else {
    const cv::Mat none;
    cv::stereoRectify(left.K, distorted ? left.D : none, right.K, distorted ? right.D : none, size, R, T, R1, R2, P1,
                      P2, Q, cv::CALIB_ZERO_DISPARITY, 0.0);
  }
  left.R = R1;
  left.P = P1;
  right.R = R2;
  right.P = P2;
  calibration.rectified = true;
}

// Whether the view is about the cameras' own. Where the lens's model folds within the picture, undistortion finds no
// answer at the border, or any, and the view without a border becomes that of a point or of nothing.
bool sensible(const StereoCalibration& calibration, cv::Size size) {
  const geometry::StereoCamera camera = rectified_camera(calibration);
  const double zoom = camera.fx / (0.5 * (calibration.left.K(0, 0) + calibration.right.K(0, 0)));
  const auto inside = [](double at, int edge) { return at >= 0.0 && at <= edge - 1.0; };
  return zoom > 1.0 / kMaxZoom && zoom < kMaxZoom && inside(camera.cx_left, size.width) &&
         inside(camera.cx_right, size.width) && inside(camera.cy, size.height);
}

}  // namespace

StereoCalibration with_rectification(const StereoCalibration& calibration, cv::Size size) {
  if (calibration.rectified) return calibration;
  if (!calibration.relative) throw std::invalid_argument("with_rectification: neither rectified nor a relative pose");
  StereoCalibration result = calibration;
  rectify(result, size, true);
  if (!sensible(result, size)) rectify(result, size, false);
  return result;
}

double row_error_px(const StereoCalibration& calibration, cv::Size size) {
  if (!calibration.relative) return 0.0;
  const cv::Matx34d& P = calibration.left.P;
  const geometry::StereoCamera camera = rectified_camera(calibration);
  // From the left camera's rectified frame to the right one's, which should not turn and shift along x only.
  const cv::Matx33d turn = calibration.right.R * calibration.relative->R * calibration.left.R.t();
  const cv::Vec3d shift = calibration.right.R * calibration.relative->T;
  double worst = 0.0;
  for (const double disparity_share : {0.0, kNearestShare}) {
    const double inverse_depth = disparity_share * size.width / (camera.fx * camera.baseline);
    for (const double u : {0.0, 0.5, 1.0}) {
      for (const double v : {0.0, 0.5, 1.0}) {
        const double row = v * (size.height - 1);
        const cv::Vec3d ray((u * (size.width - 1) - P(0, 2)) / P(0, 0), (row - P(1, 2)) / P(1, 1), 1.0);
        const cv::Vec3d seen = turn * ray + inverse_depth * shift;
        if (!(seen[2] > 0.0)) return size.height;
        worst = std::max(worst, std::abs(P(1, 1) * seen[1] / seen[2] + P(1, 2) - row));
      }
    }
  }
  return worst;
}

}  // namespace markservo::stereo_camera
