// Calibrations as others' tools write them: what they say is asked of a point in space, whose pictures in both raw
// cameras are drawn, rectified and measured.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "calibration_text.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/rectification.hpp"
#include "services/stereo-camera/calibration/rectifier.hpp"
#include "services/stereo-camera/calibration/stereo_calibration.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string data(const std::string& name) {
  return MARKSERVO_SOURCE_DIR "/tests/data/" + name;
}

CalibrationOptions with_lens(Lens lens) {
  CalibrationOptions options;
  options.lens = lens;
  return options;
}

StereoCalibration rectified(const std::vector<std::string>& paths, const CalibrationOptions& options = {}) {
  const StereoCalibration calibration = load_stereo_calibration(paths, options);
  return with_rectification(calibration, calibration.image_size.value_or(cv::Size(640, 480)));
}

// Where `p`, in the raw camera's frame (x right, y down, z ahead), is in its picture, px.
cv::Point2d raw_image(const CameraCalibration& camera, Lens lens, const cv::Vec3d& p) {
  const std::vector<cv::Point3d> points{cv::Point3d(p)};
  const cv::Vec3d none(0.0, 0.0, 0.0);
  std::vector<cv::Point2d> images;
  if (lens == Lens::kFisheye) {
    cv::fisheye::projectPoints(points, images, none, none, camera.K, camera.D);
  } else {
    cv::projectPoints(points, none, none, camera.K, camera.D, images);
  }
  return images[0];
}

cv::Mat picture_of_spot(cv::Point2d at, cv::Size size) {
  cv::Mat picture(size, CV_8UC3);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const double r2 = (u - at.x) * (u - at.x) + (v - at.y) * (v - at.y);
      picture.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(250.0 * std::exp(-r2 / (2.0 * 3.0 * 3.0))));
    }
  }
  return picture;
}

cv::Point2d spot_in(const cv::Mat& picture) {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  const cv::Moments moments = cv::moments(grey);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

struct Measured {
  double depth_m = 0.0;       // along the axis of the rectified cameras
  double true_depth_m = 0.0;  // of the same point, along the axis of the true ones
  double rows_apart_px = 0.0;
};

// How far away `used` measures a point that is 0.5 m ahead of the left raw camera and `x_per_z` of that to its right,
// and of which the pictures are those of `truth`. Both are rectified.
Measured measured(const StereoCalibration& truth, const StereoCalibration& used, double x_per_z) {
  constexpr double kDepth = 0.5;  // m
  const cv::Size size = used.image_size.value_or(cv::Size(640, 480));
  const cv::Vec3d p_left(x_per_z * kDepth, 0.02, kDepth);
  const cv::Vec3d p_right = truth.relative->R * p_left + truth.relative->T;
  cv::Mat left;
  cv::Mat right;
  Rectifier(used, size)
      .rectify(picture_of_spot(raw_image(truth.left, truth.lens, p_left), size),
               picture_of_spot(raw_image(truth.right, truth.lens, p_right), size), left, right);
  const geometry::StereoCamera camera = rectified_camera(used);
  const cv::Point2d l = spot_in(left);
  const cv::Point2d r = spot_in(right);
  const double disparity_px = (l.x - camera.cx_left) - (r.x - camera.cx_right);
  return {camera.fx * camera.baseline / disparity_px, (truth.left.R * p_left)[2], std::abs(l.y - r.y)};
}

void expect_right(const StereoCalibration& calibration, const std::vector<double>& at = {0.0, 0.3, 0.6}) {
  for (const double x_per_z : at) {
    const Measured point = measured(calibration, calibration, x_per_z);
    EXPECT_NEAR(point.depth_m / point.true_depth_m, 1.0, 0.01) << x_per_z;
    EXPECT_NEAR(point.rows_apart_px, 0.0, 0.1) << x_per_z;
  }
}

class ForeignCalibration : public testing::Test {
 protected:
  std::string error_of(const std::vector<std::string>& paths, const CalibrationOptions& options = {}) const {
    try {
      const StereoCalibration calibration = rectified(paths, options);
      const Rectifier rectifier(calibration, calibration.image_size.value_or(cv::Size(640, 480)));
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "accepted";
  }

  test::TemporaryFolder folder_;
};

TEST_F(ForeignCalibration, MayHaveItsTranslationAsAList) {
  const auto camera = rectified_camera(rectified({data("calibration/T-as-list.yml")}));
  EXPECT_NEAR(camera.fx, 500.0, 0.5);
  EXPECT_NEAR(camera.baseline, 0.06, 1e-9);
}

TEST_F(ForeignCalibration, MayHaveItsTranslationAsARowOrAColumnAndItsRotationAsAVector) {
  CalibrationText text;
  for (const char* key : {"R1", "R2", "P1", "P2"}) text.remove(key);
  for (const std::string& T : {matrix_text(1, 3, {"-0.1", "0.", "0."}), matrix_text(3, 1, {"-0.1", "0.", "0."}),
                               std::string("[[-0.1], [0], [0]]"), std::string("[[-0.1, 0, 0]]")}) {
    for (const std::string& R :
         {matrix_text(3, 1, {"0.", "0.", "0."}), std::string("[[1, 0, 0], [0, 1, 0], [0, 0, 1]]")}) {
      const std::string path = folder_.write("stereo.yml", text.set("T", T).set("R", R).text());
      EXPECT_NEAR(rectified_camera(rectified({path})).baseline, 0.1, 1e-9) << T << R;
    }
  }
  EXPECT_THAT(error_of({folder_.write("stereo.yml", text.set("T", "[ -0.1, 0. ]").text())}),
              AllOf(HasSubstr("'T' is 1 x 2"), HasSubstr("three numbers")));
}

// yaml.dump({"K1": K.tolist(), ...}) and json.dump of the same.
TEST_F(ForeignCalibration, MayBeListsThatPythonWrote) {
  const std::string yaml =
      "D1:\n- - 0.0\n  - 0.0\n  - 0.0\n  - 0.0\n  - 0.0\nD2:\n- - 0.0\n  - 0.0\n  - 0.0\n  - 0.0\n  - 0.0\n"
      "K1:\n- - 500.0\n  - 0.0\n  - 320.0\n- - 0.0\n  - 500.0\n  - 240.0\n- - 0.0\n  - 0.0\n  - 1.0\n"
      "K2:\n- - 500.0\n  - 0.0\n  - 320.0\n- - 0.0\n  - 500.0\n  - 240.0\n- - 0.0\n  - 0.0\n  - 1.0\n"
      "R:\n- - 1.0\n  - 0.0\n  - 0.0\n- - 0.0\n  - 1.0\n  - 0.0\n- - 0.0\n  - 0.0\n  - 1.0\n"
      "T:\n- - -0.06\n- - 0.0\n- - 0.0\nrms: 0.3\n";
  const std::string json = R"({"M1": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "D1": [0, 0, 0, 0, 0], "rms": 0.3,)"
                           R"( "M2": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "D2": [0, 0, 0, 0, 0],)"
                           R"( "R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "T": [-0.06, 0, 0], "image_size": [640, 480]})";
  for (const std::string& path : {folder_.write("stereo.yaml", yaml), folder_.write("stereo.json", json)}) {
    const auto camera = rectified_camera(rectified({path}));
    EXPECT_NEAR(camera.fx, 500.0, 0.5);
    EXPECT_NEAR(camera.baseline, 0.06, 1e-9);
  }
}

TEST_F(ForeignCalibration, WhoseLensModelFoldsWithinThePictureIsRectifiedAllTheSame) {
  const StereoCalibration calibration = rectified({data("calibration/rational-no-rectification.yml")});
  const auto camera = rectified_camera(calibration);
  EXPECT_NEAR(camera.fx, 704.0, 15.0);
  EXPECT_NEAR(camera.cx_left, 640.0, 15.0);
  EXPECT_NEAR(camera.baseline, 0.12, 1e-9);
  expect_right(calibration);
}

TEST_F(ForeignCalibration, ShowsNothingBeyondTheFoldOfItsLensModel) {
  const StereoCalibration calibration = rectified({data("calibration/rational-no-rectification.yml")});
  const Rectifier rectifier(calibration, *calibration.image_size);
  const cv::Mat white(720, 1280, CV_8UC3, cv::Scalar::all(255));
  cv::Mat left;
  cv::Mat right;
  rectifier.rectify(white, white, left, right);
  EXPECT_EQ(left.at<cv::Vec3b>(360, 640)[0], 255);
  EXPECT_EQ(left.at<cv::Vec3b>(2, 2)[0], 0) << "the corner is 46 degrees off the axis; the model folds at 41";
  EXPECT_GT(rectifier.shared_view().filled, 0.8);
  EXPECT_LT(rectifier.shared_view().filled, 0.99);
}

// Cameras of `width` x 480 px with focal length `f_px` whose right one is turned by `rotation` (axis times angle, rad),
// without R1, R2, P1 and P2.
CalibrationText unrectified(const std::string& width, const std::string& f_px, const std::string& D,
                            const std::string& rotation = "[0, 0, 0]") {
  CalibrationText text;
  for (const char* key : {"R1", "R2", "P1", "P2"}) text.remove(key);
  const std::string middle = std::to_string(std::stoi(width) / 2);
  const std::string K = "[[" + f_px + ", 0, " + middle + "], [0, " + f_px + ", 240], [0, 0, 1]]";
  text.set("image_width", width).set("image_height", "480").set("K1", K).set("K2", K).set("D1", D).set("D2", D);
  return text.set("R", rotation).set("T", "[-0.1, 0.002, 0.001]");
}

TEST_F(ForeignCalibration, OfABarrelThatFoldsInTheCornersIsRectifiedWithinIt) {
  // Folds at r = 0.82; the corners are at r = 0.95.
  const std::string path = folder_.write("stereo.yml", unrectified("640", "420", "[ -0.5, 0, 0, 0, 0 ]").text());
  const StereoCalibration calibration = rectified({path});
  EXPECT_NEAR(rectified_camera(calibration).fx, 420.0, 20.0);
  EXPECT_NO_THROW(Rectifier(calibration, *calibration.image_size));
  expect_right(calibration, {0.0, 0.2, 0.4});
}

TEST_F(ForeignCalibration, WithRationalCoefficientsOfTurnedCamerasIsRectified) {
  const std::string path = folder_.write(
      "stereo.yml",
      unrectified("960", "520", "[ 1.2, 0.3, 0, 0, 0.01, 1.5, 0.6, 0.05 ]", "[0.01, 0.05, -0.008]").text());
  const StereoCalibration calibration = rectified({path});
  EXPECT_NO_THROW(Rectifier(calibration, *calibration.image_size));
  expect_right(calibration, {0.0, 0.2, 0.4});
}

TEST_F(ForeignCalibration, WhoseLensModelIsNonsenseIsRefused) {
  const std::string path = folder_.write("stereo.yml", unrectified("640", "500", "[ -90, 0, 0, 0, 0 ]").text());
  EXPECT_THAT(error_of({path}), AllOf(HasSubstr("stereo.yml"), HasSubstr("lens model")));
}

TEST_F(ForeignCalibration, OfAFisheyeMeasuresRightWithItsOwnModel) {
  const StereoCalibration calibration = rectified({data("calibration/fisheye.yml")}, with_lens(Lens::kFisheye));
  EXPECT_THAT(calibration.warnings, IsEmpty());
  expect_right(calibration);
}

TEST_F(ForeignCalibration, OfAFisheyeTakenAsPinholeIsWarnedOf) {
  const StereoCalibration truth = rectified({data("calibration/fisheye.yml")}, with_lens(Lens::kFisheye));
  const StereoCalibration taken = rectified({data("calibration/fisheye.yml")});
  EXPECT_THAT(taken.warnings, ElementsAre(AllOf(HasSubstr("exactly 4 coefficients"), HasSubstr("--lens fisheye"))));
  EXPECT_GT(measured(truth, taken, 0.6).depth_m, 0.55) << "the warning would be in vain";
  EXPECT_THAT(rectified({data("calibration/fisheye.yml")}, with_lens(Lens::kPinhole)).warnings, IsEmpty());
}

TEST_F(ForeignCalibration, OfAFisheyeIsRectifiedFromRAndTToo) {
  CalibrationText text;
  for (const char* key : {"R1", "R2", "P1", "P2"}) text.remove(key);
  text.set("image_width", "640").set("image_height", "480");
  for (const char* side : {"1", "2"}) {
    text.set(std::string("K") + side, "[[286, 0, 320], [0, 286, 240], [0, 0, 1]]");
    text.set(std::string("D") + side, "[ -0.009, 0.045, -0.043, 0.008 ]");
  }
  const StereoCalibration calibration =
      rectified({folder_.write("stereo.yml", text.text())}, with_lens(Lens::kFisheye));
  expect_right(calibration);
}

TEST_F(ForeignCalibration, OfTurnedFisheyesIsRectified) {
  const std::string path = folder_.write(
      "stereo.yml", unrectified("960", "340", "[ 0.05, -0.02, 0.01, -0.003 ]", "[0.01, 0.04, -0.01]").text());
  expect_right(rectified({path}, with_lens(Lens::kFisheye)));
}

TEST_F(ForeignCalibration, OfAFisheyeHasFourCoefficients) {
  EXPECT_THAT(error_of({data("calibration/T-as-list.yml")}, with_lens(Lens::kFisheye)),
              AllOf(HasSubstr("'D1' is 1 x 5"), HasSubstr("4 coefficients")));
}

TEST_F(ForeignCalibration, MayBeRossPairOfCameraInfos) {
  const StereoCalibration calibration = rectified({data("ros/left.yaml"), data("ros/right.yaml")});
  const auto camera = rectified_camera(calibration);
  EXPECT_EQ(calibration.image_size, cv::Size(640, 480));
  EXPECT_DOUBLE_EQ(camera.fx, 600.0);
  EXPECT_DOUBLE_EQ(camera.cx_left, 319.5);
  EXPECT_DOUBLE_EQ(camera.cy, 239.5);
  EXPECT_DOUBLE_EQ(camera.baseline, 0.06);
  EXPECT_NO_THROW(Rectifier(calibration, cv::Size(640, 480)));
}

// A camera_info topic, printed.
std::string topic(const std::string& tx, const std::string& model = "plumb_bob",
                  const std::string& D = "[0, 0, 0, 0, 0]") {
  return "height: 480\nwidth: 640\ndistortion_model: " + model + "\nd: " + D +
         "\nk: [600.0, 0.0, 319.5, 0.0, 600.0, 239.5, 0.0, 0.0, 1.0]\nr: [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, "
         "1.0]\n"
         "p: [600.0, 0.0, 319.5, " +
         tx + ", 0.0, 600.0, 239.5, 0.0, 0.0, 0.0, 1.0, 0.0]\nbinning_x: 0\n---\n";
}

TEST_F(ForeignCalibration, MayBeRossTopicsPrinted) {
  const std::string left = folder_.write("left.yaml", topic("0.0"));
  const std::string right = folder_.write("right.yaml", topic("-36.0"));
  EXPECT_DOUBLE_EQ(rectified_camera(rectified({left, right})).baseline, 0.06);
}

TEST_F(ForeignCalibration, OfRosSaysItselfWhenItIsAFisheyes) {
  const std::string left = folder_.write("left.yaml", topic("0.0", "equidistant", "[0.01, 0, 0, 0]"));
  const std::string right = folder_.write("right.yaml", topic("-36.0", "equidistant", "[0.01, 0, 0, 0]"));
  EXPECT_EQ(rectified({left, right}).lens, Lens::kFisheye);
  EXPECT_THAT(error_of({left, right}, with_lens(Lens::kPinhole)), HasSubstr("equidistant"));
  EXPECT_THAT(error_of({folder_.write("odd.yaml", topic("0.0", "omni")), right}), HasSubstr("'omni'"));
}

TEST_F(ForeignCalibration, OfRosNeedsBothFilesTheLeftOneFirst) {
  EXPECT_THAT(error_of({data("ros/left.yaml")}), AllOf(HasSubstr("one camera"), HasSubstr("--calibration LEFT RIGHT")));
  EXPECT_THAT(error_of({data("ros/right.yaml"), data("ros/left.yaml")}), HasSubstr("the left camera's file first"));
  EXPECT_THAT(error_of({data("ros/left.yaml"), data("ros/left.yaml")}), HasSubstr("baseline of"));
  EXPECT_THAT(error_of({data("ros/left.yaml"), data("ros/right.yaml"), data("ros/right.yaml")}), HasSubstr("3 files"));
}

TEST_F(ForeignCalibration, OfRosIsInMetresAndInNoOtherUnit) {
  CalibrationOptions millimetres;
  millimetres.metres_per_unit = 0.1;
  CalibrationOptions squares;
  squares.board_square = 0.5;
  const std::vector<std::string> files{data("ros/left.yaml"), data("ros/right.yaml")};
  EXPECT_THAT(error_of(files, millimetres), AllOf(HasSubstr("in metres"), HasSubstr("--metres-per-unit is 0.1")));
  EXPECT_THAT(error_of(files, squares), AllOf(HasSubstr("in metres"), HasSubstr("--board-square is 0.5")));
}

TEST_F(ForeignCalibration, OfRosIsToldByItsOwnKeys) {
  const std::string left = folder_.write("left.yaml", topic("0.0"));
  EXPECT_THAT(error_of({left, folder_.write("right.yaml", topic("36.0"))}),
              AllOf(HasSubstr("right.yaml: key 'p' is "), HasSubstr("exchanged")));
  EXPECT_THAT(error_of({folder_.write("off.yaml", topic("5.0")), folder_.write("right.yaml", topic("-36.0"))}),
              HasSubstr("off.yaml: key 'p' is not at the left camera"));
}

TEST_F(ForeignCalibration, WhoseRowsDoNotAgreeIsRefused) {
  CalibrationText text;
  // The right camera looks 2 degrees up, and R2 does not know.
  text.set("R", matrix_text(3, 1, {"0.035", "0.", "0."}));
  EXPECT_THAT(error_of({folder_.write("stereo.yml", text.text())}), HasSubstr("put one point on rows"));
}

TEST_F(ForeignCalibration, WhoseRectifiedViewIsNotOfTheseCamerasIsRefused) {
  CalibrationText far;
  for (const char* key : {"P1", "P2"}) {
    far.set(key, matrix_text(3, 4,
                             {"500.", "0.", "31.5", key == std::string("P2") ? "-50." : "0.", "0.", "500.", "23.5",
                              "0.", "0.", "0.", "1.", "0."}));
  }
  EXPECT_THAT(error_of({folder_.write("stereo.yml", far.text())}), HasSubstr("is left in the rectified one"));
}

}  // namespace
}  // namespace markservo::stereo_camera
