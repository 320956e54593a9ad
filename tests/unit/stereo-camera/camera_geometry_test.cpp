#include "services/stereo-camera/calibration/camera_geometry.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/robot/configuration_error.hpp"

namespace markservo::stereo_camera {
namespace {

const std::string kRobotFile = MARKSERVO_SOURCE_DIR "/config/robot.yaml";

TEST(CameraGeometry, IsRobotYamlsWhereNothingElseIsGiven) {
  const CameraGeometry geometry = choose_geometry({}, kRobotFile);
  EXPECT_EQ(geometry.size, cv::Size(640, 480));
  EXPECT_DOUBLE_EQ(geometry.as_rectified({640, 480}).fx, 784.0);
  EXPECT_DOUBLE_EQ(geometry.as_rectified({640, 480}).baseline, 0.065);
}

TEST(CameraGeometry, OfOtherPeoplesPicturesNeedsFocalLengthAndBaselineOnly) {
  GeometryOptions options;
  options.fx = 3740.0;
  options.baseline = 0.16;
  const CameraGeometry geometry = choose_geometry(options, "no robot file is read");
  EXPECT_FALSE(geometry.size);
  const auto camera = geometry.as_rectified({1282, 1110});
  EXPECT_DOUBLE_EQ(camera.fy, 3740.0);
  EXPECT_DOUBLE_EQ(camera.cx_left, 640.5);
  EXPECT_DOUBLE_EQ(camera.cx_right, 640.5);
  EXPECT_DOUBLE_EQ(camera.cy, 554.5);
}

TEST(CameraGeometry, OfOtherPeoplesPicturesTakesWhatIsStated) {
  GeometryOptions options;
  options.fx = 100.0;
  options.fy = 101.0;
  options.cx_left = 5.0;
  options.cx_right = 6.0;
  options.cy = 7.0;
  options.baseline = 0.1;
  const auto camera = choose_geometry(options, "").as_rectified({64, 48});
  EXPECT_DOUBLE_EQ(camera.fy, 101.0);
  EXPECT_DOUBLE_EQ(camera.cx_left, 5.0);
  EXPECT_DOUBLE_EQ(camera.cx_right, 6.0);
  EXPECT_DOUBLE_EQ(camera.cy, 7.0);
}

TEST(CameraGeometry, OfOtherPeoplesPicturesMustBePossibleForThem) {
  GeometryOptions options;
  options.fx = 3740.0;
  options.baseline = 0.16;
  const CameraGeometry geometry = choose_geometry(options, "");
  EXPECT_NO_THROW(geometry.as_rectified({1282, 1110}));
  EXPECT_THROW(geometry.as_rectified({64, 48}), ConfigurationError);
}

TEST(CameraGeometry, RefusesImpossibleOrHalfSettings) {
  GeometryOptions half;
  half.fx = 100.0;
  EXPECT_THROW(choose_geometry(half, kRobotFile), ConfigurationError);
  GeometryOptions negative = half;
  negative.baseline = -0.1;
  EXPECT_THROW(choose_geometry(negative, kRobotFile), ConfigurationError);
  GeometryOptions millimetres = half;
  millimetres.baseline = 65.0;
  EXPECT_THROW(choose_geometry(millimetres, kRobotFile), ConfigurationError);
  GeometryOptions two_units = half;
  two_units.fx.reset();
  two_units.calibration = {"stereo.yml"};
  two_units.metres_per_unit = 0.001;
  two_units.board_square = 0.025;
  EXPECT_THROW(choose_geometry(two_units, kRobotFile), ConfigurationError);
  GeometryOptions infinite = half;
  infinite.baseline = 0.1;
  infinite.cx_left = std::numeric_limits<double>::infinity();
  EXPECT_THROW(choose_geometry(infinite, kRobotFile), ConfigurationError);
  GeometryOptions twice = half;
  twice.baseline = 0.1;
  twice.calibration = {"stereo.yml"};
  EXPECT_THROW(choose_geometry(twice, kRobotFile), ConfigurationError);
  GeometryOptions one_file;
  one_file.intrinsics = "intrinsics.yml";
  EXPECT_THROW(choose_geometry(one_file, kRobotFile), ConfigurationError);
}

}  // namespace
}  // namespace markservo::stereo_camera
