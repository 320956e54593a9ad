#include "services/stereo-camera/calibration/chosen_cameras.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibration_text.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

class ChosenCamerasOf : public testing::Test {
 protected:
  CameraGeometry geometry_of(const CalibrationText& text) const {
    GeometryOptions options;
    options.calibration = {folder_.write("stereo.yml", text.text())};
    return choose_geometry(options, "no robot file is read");
  }
  std::string refusal(const CalibrationText& text, cv::Size size) const {
    try {
      choose_cameras(geometry_of(text), size);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "accepted";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ChosenCamerasOf, ACalibrationAreTheRectifiedOnesAndSaidInOneLine) {
  const ChosenCameras cameras = choose_cameras(geometry_of(CalibrationText()), {64, 48});
  EXPECT_DOUBLE_EQ(cameras.camera.fx, 50.0);
  EXPECT_DOUBLE_EQ(cameras.camera.baseline, 0.1);
  EXPECT_TRUE(cameras.rectifier);
  EXPECT_THAT(cameras.warnings, IsEmpty());
  EXPECT_EQ(cameras.summary,
            "cameras: f 50.0 px, baseline 0.1000 m; 100% of the rectified pictures show something, 100% of the "
            "cameras' pictures are left");
}

TEST_F(ChosenCamerasOf, AnOptionAreTakenAsRectified) {
  GeometryOptions options;
  options.fx = 600.0;
  options.baseline = 0.06;
  const ChosenCameras cameras = choose_cameras(choose_geometry(options, ""), {640, 480});
  EXPECT_FALSE(cameras.rectifier);
  EXPECT_EQ(cameras.summary, "cameras: f 600.0 px, baseline 0.0600 m; pictures are taken as rectified");
}

TEST_F(ChosenCamerasOf, PicturesOfAnotherSizeAreRefused) {
  EXPECT_THAT(refusal(CalibrationText(), {128, 96}),
              AllOf(HasSubstr("128 x 96 px"), HasSubstr("64 x 48 px"), HasSubstr("stereo.yml")));
}

// For pictures of 128 x 96 px, say, whose size nothing but the principal point tells.
TEST_F(ChosenCamerasOf, ACalibrationWithoutASizeAreRefusedWhoseMiddleIsElsewhere) {
  CalibrationText text;
  text.remove("image_width").remove("image_height");
  EXPECT_EQ(refusal(text, {64, 48}), "accepted");
  EXPECT_THAT(refusal(text, {128, 96}), AllOf(HasSubstr("principal point is (31.5, 23.5) px"), HasSubstr("128 x 96 px"),
                                              HasSubstr("was it made for another?")));
}

TEST_F(ChosenCamerasOf, PicturesThatWereCutOutAreTakenWithAWarning) {
  CalibrationText text;
  for (const char* key : {"R1", "R2", "P1", "P2"}) text.remove(key);
  const std::string K = matrix_text(3, 3, {"50.", "0.", "9.5", "0.", "50.", "23.5", "0.", "0.", "1."});
  const ChosenCameras cameras = choose_cameras(geometry_of(text.set("K1", K).set("K2", K)), {64, 48});
  EXPECT_NEAR(cameras.camera.cx_left, 9.5, 1.0);
  EXPECT_NEAR(cameras.camera.fx, 50.0, 2.0);
  EXPECT_THAT(cameras.warnings, testing::ElementsAre(HasSubstr("right only if they are cut out of larger ones")));
}

}  // namespace
}  // namespace markservo::stereo_camera
