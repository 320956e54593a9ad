#include "services/stereo-camera/calibration/lens.hpp"

#include <cmath>

namespace markservo::stereo_camera {
namespace {

constexpr double kLargestAngle = 80.0 / 180.0 * CV_PI;  // rad
constexpr double kAngleStep = 0.001;                    // rad: less than a pixel of any camera

// Coefficient `index`, or 0 where there are fewer.
double coefficient(const cv::Mat& D, int index) {
  return index < static_cast<int>(D.total()) ? D.at<double>(index) : 0.0;
}

// Where a ray at `angle` to the axis is seen, in focal lengths from the principal point.
double pinhole_radius(const cv::Mat& D, double angle) {
  const double r = std::tan(angle);
  const double r2 = r * r;
  const double above = 1.0 + r2 * (coefficient(D, 0) + r2 * (coefficient(D, 1) + r2 * coefficient(D, 4)));
  const double below = 1.0 + r2 * (coefficient(D, 5) + r2 * (coefficient(D, 6) + r2 * coefficient(D, 7)));
  return below > 0.0 ? r * above / below : -1.0;
}

double fisheye_radius(const cv::Mat& D, double angle) {
  const double a2 = angle * angle;
  return angle * (1.0 + a2 * (coefficient(D, 0) +
                              a2 * (coefficient(D, 1) + a2 * (coefficient(D, 2) + a2 * coefficient(D, 3)))));
}

}  // namespace

std::string four_coefficients_warning(const std::string& path, const std::string& key) {
  return path + ": '" + key +
         "' has exactly 4 coefficients, taken as k1 k2 p1 p2 of the pinhole model; those of cv::fisheye need --lens "
         "fisheye (--lens pinhole says that they are not)";
}

double radius_of_validity(const cv::Mat& D, Lens lens) {
  double seen = 0.0;
  for (double angle = kAngleStep; angle < kLargestAngle; angle += kAngleStep) {
    const double further = lens == Lens::kFisheye ? fisheye_radius(D, angle) : pinhole_radius(D, angle);
    if (!(further > seen)) return std::tan(angle - kAngleStep);
    seen = further;
  }
  return std::tan(kLargestAngle);
}

}  // namespace markservo::stereo_camera
