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
  EXPECT_DOUBLE_EQ(geometry.camera({640, 480}).fx, 784.0);
  EXPECT_DOUBLE_EQ(geometry.camera({640, 480}).baseline, 0.065);
}

TEST(CameraGeometry, OfOtherPeoplesPicturesNeedsFocalLengthAndBaselineOnly) {
  GeometryOptions options;
  options.fx = 3740.0;
  options.baseline = 0.16;
  const CameraGeometry geometry = choose_geometry(options, "no robot file is read");
  EXPECT_FALSE(geometry.size);
  const auto camera = geometry.camera({1282, 1110});
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
  const auto camera = choose_geometry(options, "").camera({64, 48});
  EXPECT_DOUBLE_EQ(camera.fy, 101.0);
  EXPECT_DOUBLE_EQ(camera.cx_left, 5.0);
  EXPECT_DOUBLE_EQ(camera.cx_right, 6.0);
  EXPECT_DOUBLE_EQ(camera.cy, 7.0);
}

TEST(CameraGeometry, RefusesImpossibleOrHalfSettings) {
  GeometryOptions half;
  half.fx = 100.0;
  EXPECT_THROW(choose_geometry(half, kRobotFile), ConfigurationError);
  GeometryOptions negative = half;
  negative.baseline = -0.1;
  EXPECT_THROW(choose_geometry(negative, kRobotFile), ConfigurationError);
  GeometryOptions infinite = half;
  infinite.baseline = 0.1;
  infinite.cx_left = std::numeric_limits<double>::infinity();
  EXPECT_THROW(choose_geometry(infinite, kRobotFile), ConfigurationError);
  GeometryOptions twice = half;
  twice.baseline = 0.1;
  twice.calibration = "stereo.yml";
  EXPECT_THROW(choose_geometry(twice, kRobotFile), ConfigurationError);
  GeometryOptions one_file;
  one_file.intrinsics = "intrinsics.yml";
  EXPECT_THROW(choose_geometry(one_file, kRobotFile), ConfigurationError);
}

}  // namespace
}  // namespace markservo::stereo_camera
