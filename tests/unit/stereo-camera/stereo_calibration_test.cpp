#include "services/stereo-camera/calibration/stereo_calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "calibration_text.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/calibration/rectification.hpp"
#include "services/stereo-camera/calibration/rectifier.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StereoCalibrationFile : public testing::Test {
 protected:
  // The error of loading `text`, or "accepted".
  std::string error_of(const std::string& text, const CalibrationOptions& options = {}) const {
    return error_of_files({folder_.write("stereo.yml", text)}, options);
  }
  std::string error_of_files(const std::vector<std::string>& paths, const CalibrationOptions& options = {}) const {
    try {
      load_stereo_calibration(paths, options);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "accepted";
  }
  std::string error_of(const CalibrationText& text, const CalibrationOptions& options = {}) const {
    return error_of(text.text(), options);
  }

  test::TemporaryFolder folder_;
  CalibrationText good_;
};

TEST_F(StereoCalibrationFile, GivesFocalLengthPrincipalPointAndBaselineOfP1AndP2) {
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {});
  const auto camera = rectified_camera(calibration);
  EXPECT_EQ(calibration.image_size, cv::Size(64, 48));
  EXPECT_DOUBLE_EQ(camera.fx, 50.0);
  EXPECT_DOUBLE_EQ(camera.fy, 50.0);
  EXPECT_DOUBLE_EQ(camera.cx_left, 31.5);
  EXPECT_DOUBLE_EQ(camera.cx_right, 31.5);
  EXPECT_DOUBLE_EQ(camera.cy, 23.5);
  EXPECT_DOUBLE_EQ(camera.baseline, 0.1);
}

TEST_F(StereoCalibrationFile, TakesTheUnitOfItsBoard) {
  good_.set("P2", CalibrationText::projection("-5000.")).set("T", matrix_text(3, 1, {"-100.", "0.", "0."}));
  EXPECT_THAT(error_of(good_), AllOf(HasSubstr("P2"), HasSubstr("100 m"), HasSubstr("--metres-per-unit 0.001")));
  CalibrationOptions millimetres;
  millimetres.metres_per_unit = 0.001;
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, millimetres);
  EXPECT_DOUBLE_EQ(rectified_camera(calibration).baseline, 0.1);
}

TEST_F(StereoCalibrationFile, MayCountInSquaresOfItsBoard) {
  good_.set("P2", CalibrationText::projection("-200.")).set("T", matrix_text(3, 1, {"-4.", "0.", "0."}));
  EXPECT_THAT(error_of(good_), AllOf(HasSubstr("4 m"), HasSubstr("--board-square EDGE, in m")));
  CalibrationOptions squares;
  squares.board_square = 0.025;
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, squares);
  EXPECT_DOUBLE_EQ(rectified_camera(calibration).baseline, 0.1);
  EXPECT_DOUBLE_EQ(cv::norm(calibration.relative->T), 0.1);
}

TEST_F(StereoCalibrationFile, ThatStatesItsSquareNeedsItsTrueEdgeOnly) {
  good_.set("P2", CalibrationText::projection("-5000.")).set("T", matrix_text(3, 1, {"-100.", "0.", "0."}));
  CalibrationOptions squares;
  squares.board_square = 0.030;  // stated in mm, and a little too small
  const auto calibration =
      load_stereo_calibration({folder_.write("stereo.yml", good_.set("square_size", "25.").text())}, squares);
  EXPECT_DOUBLE_EQ(rectified_camera(calibration).baseline, 0.12);
  EXPECT_THAT(error_of(good_.set("square_size", "0"), squares), HasSubstr("square_size"));
}

TEST_F(StereoCalibrationFile, InMillimetresIsNotTakenForOneInSquares) {
  good_.set("P2", CalibrationText::projection("-5000.")).set("T", matrix_text(3, 1, {"-100.", "0.", "0."}));
  CalibrationOptions squares;
  squares.board_square = 0.025;
  EXPECT_THAT(error_of(good_, squares), AllOf(HasSubstr("100 squares between the cameras"), HasSubstr("up to 25")));
}

TEST_F(StereoCalibrationFile, NeedsNoHeader) {
  EXPECT_EQ(error_of(good_.body()), "accepted");
  EXPECT_EQ(error_of("\xEF\xBB\xBF" + good_.text()), "accepted") << "a mark that Windows' editors set";
}

TEST_F(StereoCalibrationFile, WithATypingErrorInItsSyntaxIsRefusedWithTheLine) {
  EXPECT_THAT(error_of(std::string("%YAML:1.0\n---\nrms: 0.2\nK1: ]\nK2: 5\n")),
              AllOf(HasSubstr("stereo.yml: line 4: "), HasSubstr("allowed: well-formed YAML")));
  EXPECT_THAT(error_of(std::string("<?xml version=\"1.0\"?>\n<opencv_storage>\n<rms>1</xms>\n</opencv_storage>\n")),
              AllOf(HasSubstr("stereo.yml: line 3: "), HasSubstr("allowed: well-formed XML")));
  EXPECT_THAT(error_of(std::string("%YAML:1.0\n---\n")), HasSubstr("has no keys"));
  EXPECT_THAT(error_of(std::string()), HasSubstr("empty"));
}

TEST_F(StereoCalibrationFile, WithAKeyTwiceIsRefusedWithBothLines) {
  EXPECT_THAT(error_of("rms: 0.2\n" + good_.body()), HasSubstr("key 'rms' stands twice, on lines 1 and "));
}

TEST_F(StereoCalibrationFile, ThatEndsTooEarlyIsRefusedWithTheLine) {
  for (const char* text :
       {"<?xml version=\"1.0\"?>\n<opencv_storage>\n<rms>1", "<?xml version=\"1.0\"?>\n<opencv_storage>\n<rms>",
        "<?xml version=\"1.0\"?>\n<opencv_storage>\n<rm", "<?xml version=\"1.0\"?>\n<opencv_storage>\n<rms>1</rms>"}) {
    EXPECT_THAT(error_of(std::string(text)),
                AllOf(HasSubstr("stereo.yml: line 3: "), HasSubstr("allowed: well-formed XML"),
                      Not(HasSubstr("OpenCV(")), Not(HasSubstr("\n"))))
        << text;
  }
}

// Some beginnings of a file crash OpenCV's parser.
TEST_F(StereoCalibrationFile, ThatIsTheBeginningOfAnXmlIsRefused) {
  const std::string whole =
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- a -->\n<K1 type_id=\"opencv-matrix\">\n<rows>1</rows>\n"
      "<cols>2</cols>\n<dt>d</dt>\n<data>\n50. 0.</data></K1>\n<name>\"text\"</name>\n</opencv_storage>";
  for (std::size_t length = 1; length < whole.size(); ++length) {
    EXPECT_THAT(error_of(whole.substr(0, length)), AllOf(HasSubstr("stereo.yml: line "), Not(HasSubstr("OpenCV("))));
  }
}

TEST_F(StereoCalibrationFile, MayBeNoFolder) {
  EXPECT_THAT(error_of_files({folder_.file("")}), AllOf(HasSubstr("is not a file"), HasSubstr("allowed")));
}

TEST_F(StereoCalibrationFile, MustBeThere) {
  EXPECT_THROW(load_stereo_calibration({folder_.file("absent.yml")}, {}), ConfigurationError);
}

TEST_F(StereoCalibrationFile, NeedsEveryKey) {
  for (const std::string key : {"image_width", "image_height", "rms", "K1", "D1", "K2", "D2", "R1", "R2", "P1", "P2"}) {
    const std::string error = error_of(CalibrationText().remove(key));
    EXPECT_THAT(error, AllOf(HasSubstr("stereo.yml"), HasSubstr("'" + key + "' is missing"), HasSubstr("allowed")));
    EXPECT_THAT(error, Not(HasSubstr("\n")));
  }
}

TEST_F(StereoCalibrationFile, MayHaveNoSingularMatrix) {
  const std::string zeros3 = matrix_text(3, 3, std::vector<std::string>(9, "0."));
  const std::string zeros4 = matrix_text(3, 4, std::vector<std::string>(12, "0."));
  for (const std::string key : {"K1", "K2", "R1", "R2"}) {
    EXPECT_THAT(error_of(CalibrationText().set(key, zeros3)), AllOf(HasSubstr(key), HasSubstr("singular")));
  }
  for (const std::string key : {"P1", "P2"}) {
    EXPECT_THAT(error_of(CalibrationText().set(key, zeros4)), AllOf(HasSubstr(key), HasSubstr("singular")));
  }
}

TEST_F(StereoCalibrationFile, MayHaveNoMatrixOfAnotherShapeOrKind) {
  EXPECT_THAT(error_of(CalibrationText().set("K1", matrix_text(2, 2, {"1.", "0.", "0.", "1."}))),
              AllOf(HasSubstr("K1"), HasSubstr("2 x 2"), HasSubstr("3 x 3")));
  EXPECT_THAT(error_of(CalibrationText().set("D1", matrix_text(1, 3, {"0.", "0.", "0."}))), HasSubstr("D1"));
  EXPECT_THAT(error_of(CalibrationText().set("K1", "5")), HasSubstr("K1"));
  EXPECT_THAT(error_of(CalibrationText().set("K1", "none")), HasSubstr("K1"));
  EXPECT_THAT(error_of(CalibrationText().set("K1", matrix_text(3, 3, {"1."}))), HasSubstr("K1"));
  EXPECT_THAT(error_of(CalibrationText().set("K1", matrix_text(-3, 3, {"1."}))), HasSubstr("K1"));
}

TEST_F(StereoCalibrationFile, MayHaveNoMatrixOfWhichAPartIsMissing) {
  for (const char* K1 : {"{cols: 1, data: [1, 2, 3]}", "{rows: 3, data: [1, 2, 3]}", "{rows: 3, cols: 3}", "{a: 1}",
                         "{rows: [], cols: 1, data: [1]}", "{rows: 1, cols: 1, data: 5}", "[[1, 2], 3]",
                         "{rows: 4.5, cols: 2, data: [1, 2, 3, 4, 5, 6, 7, 8, 9]}",
                         "{rows: 1.5, cols: 2, data: [1, 2, 3]}", "{rows: -1, cols: -1, data: [1]}"}) {
    EXPECT_THAT(error_of(CalibrationText().set("K1", K1)), HasSubstr("'K1' is ")) << K1;
  }
}

TEST_F(StereoCalibrationFile, MayHaveNoNumberThatIsNotFinite) {
  EXPECT_THAT(error_of(CalibrationText().set("D1", matrix_text(1, 4, {".NaN", "0.", "0.", "0."}))),
              AllOf(HasSubstr("D1"), HasSubstr("not finite")));
  EXPECT_THAT(error_of(CalibrationText().set("rms", ".Inf")), AllOf(HasSubstr("rms"), HasSubstr("not finite")));
}

TEST_F(StereoCalibrationFile, MayHaveNoMirroredRotation) {
  const std::string mirror = matrix_text(3, 3, {"-1.", "0.", "0.", "0.", "1.", "0.", "0.", "0.", "1."});
  EXPECT_THAT(error_of(good_.set("R1", mirror)), AllOf(HasSubstr("R1"), HasSubstr("rotation")));
}

TEST_F(StereoCalibrationFile, NeedsAPossibleImageSize) {
  EXPECT_THAT(error_of(CalibrationText().set("image_width", "0")), HasSubstr("image_width"));
  EXPECT_THAT(error_of(CalibrationText().set("image_height", "-48")), HasSubstr("image_height"));
  EXPECT_THAT(error_of(CalibrationText().set("image_width", "100000")), HasSubstr("16384"));
  EXPECT_THAT(error_of(CalibrationText().set("image_width", "wide")), HasSubstr("image_width"));
}

TEST_F(StereoCalibrationFile, MayStateTheImageSizeAsAPair) {
  good_.remove("image_width").remove("image_height").set("image_size", "[ 64, 48 ]");
  EXPECT_EQ(load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {}).image_size, cv::Size(64, 48));
  EXPECT_THAT(error_of(good_.set("image_size", "[ 64 ]")), HasSubstr("image_size"));
}

TEST_F(StereoCalibrationFile, IsRefusedAboveHalfAPixelOfErrorUnlessToldOtherwise) {
  CalibrationOptions any;
  any.accept_any_error = true;
  for (const std::string key : {"rms", "epipolar_error"}) {
    const CalibrationText bad = CalibrationText().set(key, "0.51");
    EXPECT_THAT(error_of(bad),
                AllOf(HasSubstr(key), HasSubstr("0.51"), HasSubstr("0.5 px"), HasSubstr("--accept-rms")));
    EXPECT_EQ(error_of(bad, any), "accepted");
    EXPECT_EQ(error_of(CalibrationText().set(key, "0.49")), "accepted");
  }
  EXPECT_EQ(error_of(CalibrationText().remove("rms"), any), "accepted");
}

TEST_F(StereoCalibrationFile, IsRefusedForAnErrorThatEitherOfTwoFilesStates) {
  CalibrationText silent = good_;
  const std::string none = folder_.write("none.yml", silent.remove("rms").text());
  const std::string bad = folder_.write("bad.yml", CalibrationText().set("rms", "5").text());
  const auto error = [&](const std::string& first, const std::string& second) {
    return error_of_files({first, second});
  };
  EXPECT_THAT(error(bad, bad), AllOf(HasSubstr("bad.yml"), HasSubstr("'rms' is 5 px")));
  EXPECT_THAT(error(bad, none), HasSubstr("'rms' is 5 px"));
  EXPECT_THAT(error(none, bad), HasSubstr("'rms' is 5 px"));
  EXPECT_THAT(error(none, none), HasSubstr("'rms' is missing")) << "one file, named twice";
  const std::string also_none = folder_.write("also_none.yml", silent.text());
  EXPECT_THAT(load_stereo_calibration({none, also_none}, {}).warnings,
              testing::ElementsAre(HasSubstr("none.yml: states no reprojection error")));
  const std::string good = folder_.write("good.yml", good_.text());
  EXPECT_TRUE(load_stereo_calibration({none, good}, {}).warnings.empty()) << "it is stated";
}

TEST_F(StereoCalibrationFile, NamesTheLensOfFourCoefficients) {
  const std::string four = matrix_text(1, 4, {"0.", "0.", "0.", "0."});
  const auto warnings = [&](const std::string& key) {
    const std::string path = folder_.write("four.yml", CalibrationText().set(key, four).text());
    return load_stereo_calibration({path}, {}).warnings;
  };
  EXPECT_THAT(warnings("D1"), testing::ElementsAre(HasSubstr("'D1' has exactly 4")));
  EXPECT_THAT(warnings("D2"), testing::ElementsAre(HasSubstr("'D2' has exactly 4")));
}

TEST_F(StereoCalibrationFile, NeedsAPositiveBaseline) {
  EXPECT_THAT(error_of(CalibrationText().set("P2", CalibrationText::projection("5."))),
              AllOf(HasSubstr("P2"), HasSubstr("-0.1 m"), HasSubstr("exchanged")));
  EXPECT_THAT(error_of(CalibrationText().set("P2", CalibrationText::projection("0."))), HasSubstr("baseline of"));
}

TEST_F(StereoCalibrationFile, MayNotMixCalibrations) {
  EXPECT_THAT(error_of(CalibrationText().set("T", matrix_text(3, 1, {"-0.2", "0.", "0."}))),
              AllOf(HasSubstr("'T'"), HasSubstr("0.2 m"), HasSubstr("0.1 m")));
  const std::string other =
      matrix_text(3, 4, {"60.", "0.", "31.5", "-6.", "0.", "60.", "23.5", "0.", "0.", "0.", "1.", "0."});
  EXPECT_THAT(error_of(CalibrationText().set("P2", other)), AllOf(HasSubstr("P2"), HasSubstr("P1")));
}

TEST_F(StereoCalibrationFile, WithoutRectificationIsRectifiedByRAndT) {
  good_.remove("R1").remove("R2").remove("P1").remove("P2");
  const auto raw = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {});
  EXPECT_FALSE(raw.rectified);
  const auto calibration = with_rectification(raw, *raw.image_size);
  const auto camera = rectified_camera(calibration);
  EXPECT_NEAR(camera.baseline, 0.1, 1e-12);
  EXPECT_EQ(camera.cx_left, camera.cx_right);  // zero disparity at infinity
  EXPECT_NEAR(camera.fx, 50.0, 2.0);
}

TEST_F(StereoCalibrationFile, MayBeThePairThatTheSampleOfOpenCvWrites) {
  CalibrationText intrinsics;
  for (const std::string key : {"image_width", "image_height", "rms", "R", "T", "R1", "R2", "P1", "P2", "K1", "K2"}) {
    intrinsics.remove(key);
  }
  const std::string K = matrix_text(3, 3, {"50.", "0.", "31.5", "0.", "50.", "23.5", "0.", "0.", "1."});
  intrinsics.set("M1", K).set("M2", K);
  const std::string first = folder_.write("intrinsics.yml", intrinsics.text());
  const std::string second = folder_.write("extrinsics.yml", good_.text());
  const auto calibration = load_stereo_calibration({first, second}, {});
  EXPECT_FALSE(calibration.image_size);
  EXPECT_DOUBLE_EQ(rectified_camera(calibration).baseline, 0.1);
}

TEST_F(StereoCalibrationFile, MayBeXml) {
  const std::string path = folder_.file("stereo.xml");
  {
    const cv::FileStorage yaml(folder_.write("stereo.yml", good_.text()), cv::FileStorage::READ);
    cv::FileStorage xml(path, cv::FileStorage::WRITE);
    for (const std::string key : {"K1", "D1", "K2", "D2", "R1", "R2", "P1", "P2"}) xml << key << yaml[key].mat();
    xml << "image_size" << cv::Size(64, 48) << "rms" << 0.2;
  }
  EXPECT_DOUBLE_EQ(rectified_camera(load_stereo_calibration({path}, {})).baseline, 0.1);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(error_of("\xEF\xBB\xBF" + text), "accepted") << "a mark that Windows' editors set";
}

// Rectification knows no skew: what it ignored would be measured wrong.
TEST_F(StereoCalibrationFile, MayHaveNoSkew) {
  const std::string K = matrix_text(3, 3, {"50.", "40.", "31.5", "0.", "50.", "23.5", "0.", "0.", "1."});
  for (const char* key : {"K1", "K2"}) {
    EXPECT_THAT(error_of(CalibrationText().set(key, K)), AllOf(HasSubstr(key), HasSubstr("skewed pixels (40 px)")));
  }
}

TEST_F(StereoCalibrationFile, OfIdealCamerasLeavesPicturesAsTheyAre) {
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {});
  const Rectifier rectifier(calibration, *calibration.image_size);
  cv::Mat raw(48, 64, CV_8UC3);
  cv::randu(raw, 0, 256);
  cv::Mat left;
  cv::Mat right;
  rectifier.rectify(raw, raw, left, right);
  EXPECT_EQ(cv::norm(left, raw, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(right, raw, cv::NORM_INF), 0.0);
  EXPECT_THROW(rectifier.rectify(raw.rowRange(0, 20), raw, left, right), std::invalid_argument);
}

TEST_F(StereoCalibrationFile, WithoutAnImageSizeIsForThePicturesAndSaysSo) {
  good_.remove("image_width").remove("image_height");
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {});
  EXPECT_FALSE(calibration.image_size);
  EXPECT_THAT(calibration.warnings, testing::ElementsAre(HasSubstr("states no image size")));
  EXPECT_NO_THROW(Rectifier(calibration, cv::Size(64, 48)));
}

TEST_F(StereoCalibrationFile, OfAnotherImageSizeIsRefused) {
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.text())}, {});
  EXPECT_NO_THROW(Rectifier(calibration, cv::Size(64, 48)));
  EXPECT_THROW(Rectifier(calibration, cv::Size(640, 480)), ConfigurationError);
}

TEST_F(StereoCalibrationFile, ThatTurnsTheViewOutOfThePictureIsRefused) {
  const std::string turn = matrix_text(3, 3, {"0.5", "0.", "-0.8660254", "0.", "1.", "0.", "0.8660254", "0.", "0.5"});
  const auto calibration = load_stereo_calibration({folder_.write("stereo.yml", good_.set("R1", turn).text())}, {});
  EXPECT_THROW(Rectifier(calibration, cv::Size(64, 48)), ConfigurationError);
}

}  // namespace
}  // namespace markservo::stereo_camera
