#include "services/stereo-camera/calibration/lens.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::stereo_camera {
namespace {

const double kLargest = std::tan(80.0 / 180.0 * CV_PI);

cv::Mat row(std::vector<double> coefficients) {
  return cv::Mat(coefficients, true).reshape(1, 1);
}

TEST(RadiusOfValidity, IsAsFarAsAFlatPictureReachesForALensWithoutAFold) {
  EXPECT_NEAR(radius_of_validity(row({0, 0, 0, 0, 0}), Lens::kPinhole), kLargest, 0.05);
  EXPECT_NEAR(radius_of_validity(row({0.1, 0.01, 0, 0}), Lens::kPinhole), kLargest, 0.05);
  EXPECT_NEAR(radius_of_validity(row({0, 0, 0, 0}), Lens::kFisheye), kLargest, 0.05);
}

// r (1 + k1 r^2) is greatest where 1 + 3 k1 r^2 = 0.
TEST(RadiusOfValidity, EndsWhereABarrelFolds) {
  EXPECT_NEAR(radius_of_validity(row({-0.4, 0, 0, 0, 0}), Lens::kPinhole), std::sqrt(1.0 / 1.2), 0.003);
  EXPECT_NEAR(radius_of_validity(row({-0.2, 0.4, 0, 0, 0, 0, 0, 0.8}), Lens::kPinhole), 0.875, 0.01);
}

TEST(RadiusOfValidity, EndsWhereAFisheyesAngleFolds) {
  EXPECT_NEAR(radius_of_validity(row({-0.3, 0, 0, 0}), Lens::kFisheye), std::tan(std::sqrt(1.0 / 0.9)), 0.01);
}

}  // namespace
}  // namespace markservo::stereo_camera
