#include "common/geometry/camera_bounds.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::geometry {
namespace {

const StereoCamera kUsual{784.0, 784.0, 319.5, 319.5, 239.5, 0.065};

std::string complaint(double StereoCamera::*field, double value) {
  StereoCamera camera = kUsual;
  camera.*field = value;
  return implausibility(camera, 640, 480);
}

TEST(CameraBounds, HoldUsualCameras) {
  EXPECT_EQ(implausibility(kUsual, 640, 480), "");
  EXPECT_EQ(implausibility({3740.0, 3740.0, 640.5, 700.0, 554.5, 0.16}, 1282, 1110), "");
  EXPECT_EQ(implausibility({216.6, 216.6, 320.0, 320.0, 240.0, 0.064}, 640, 480), "") << "a wide view made flat";
}

TEST(CameraBounds, RefuseABaselineInMillimetresOrOfNoLength) {
  EXPECT_EQ(complaint(&StereoCamera::baseline, 65.0), "baseline is 65 m; allowed: 0.001 to 2 m");
  EXPECT_NE(complaint(&StereoCamera::baseline, 6.5e-5), "");
  EXPECT_NE(complaint(&StereoCamera::baseline, -0.065), "");
}

TEST(CameraBounds, RefuseWhatNoLensDoes) {
  EXPECT_EQ(complaint(&StereoCamera::fx, 3.6e9), "fx is 3.6e+09 px; allowed: 64 to 19200 px");
  EXPECT_NE(complaint(&StereoCamera::fy, 10.0), "");
  EXPECT_NE(complaint(&StereoCamera::cx_left, 5.7e9), "");
  EXPECT_NE(complaint(&StereoCamera::cx_right, -400.0), "");
  EXPECT_NE(complaint(&StereoCamera::cy, 1000.0), "");
}

TEST(CameraBounds, RefuseWhatIsNoNumber) {
  for (auto field : {&StereoCamera::fx, &StereoCamera::fy, &StereoCamera::cx_left, &StereoCamera::cx_right,
                     &StereoCamera::cy, &StereoCamera::baseline}) {
    EXPECT_NE(complaint(field, std::numeric_limits<double>::quiet_NaN()), "");
    EXPECT_NE(complaint(field, std::numeric_limits<double>::infinity()), "");
  }
}

}  // namespace
}  // namespace markservo::geometry
