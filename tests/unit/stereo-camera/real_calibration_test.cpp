// Thirteen photographed chessboard pairs of two real cameras: calibrated here with OpenCV, rectified by the executable.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "command.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::HasSubstr;

const cv::Size kBoard(9, 6);         // inner corners
constexpr float kSquare_m = 0.025F;  // assumed: the photographs state none
constexpr int kPairs = 13;

std::string example(const std::string& side, int number) {
  char name[32];
  std::snprintf(name, sizeof name, "/%s%02d.jpg", side.c_str(), number);
  return OPENCV_EXAMPLES + std::string(name);
}

std::vector<cv::Point2f> corners_of(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCorners(grey, kBoard, corners)) return {};
  cv::cornerSubPix(grey, corners, cv::Size(5, 5), cv::Size(-1, -1),
                   cv::TermCriteria(cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 50, 1e-3));
  return corners;
}

// Root mean square of the corners' row difference between both pictures, px, and how many pairs had a board.
struct RowError {
  double rms_px = 0.0;
  int boards = 0;
};

class RowErrorSum {
 public:
  void add(const cv::Mat& left, const cv::Mat& right) {
    const auto l = corners_of(left);
    const auto r = corners_of(right);
    if (l.empty() || r.empty()) return;
    ++boards_;
    for (std::size_t i = 0; i < l.size(); ++i) {
      const double difference = l[i].y - r[i].y;
      sum_ += difference * difference;
      ++count_;
    }
  }
  RowError result() const { return {std::sqrt(sum_ / static_cast<double>(count_)), boards_}; }

 private:
  double sum_ = 0.0;
  std::int64_t count_ = 0;
  int boards_ = 0;
};

class RealCameras : public testing::Test {
 protected:
  // Calibrates once for all tests of this suite.
  static void SetUpTestSuite() {
    std::vector<std::vector<cv::Point3f>> boards;
    std::vector<std::vector<cv::Point2f>> left;
    std::vector<std::vector<cv::Point2f>> right;
    std::vector<cv::Point3f> board;
    for (int row = 0; row < kBoard.height; ++row) {
      for (int column = 0; column < kBoard.width; ++column) {
        board.emplace_back(kSquare_m * static_cast<float>(column), kSquare_m * static_cast<float>(row), 0.0F);
      }
    }
    RowErrorSum raw;
    for (int number = 1; number <= 14; ++number) {
      if (number == 10) continue;  // not among the photographs
      const cv::Mat l = cv::imread(example("left", number));
      const cv::Mat r = cv::imread(example("right", number));
      ASSERT_FALSE(l.empty() || r.empty()) << "install opencv-doc: " << example("left", number) << " is missing";
      size_ = l.size();
      const auto corners_left = corners_of(l);
      const auto corners_right = corners_of(r);
      if (corners_left.empty() || corners_right.empty()) continue;
      boards.push_back(board);
      left.push_back(corners_left);
      right.push_back(corners_right);
      raw.add(l, r);
    }
    raw_ = raw.result();
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    cv::calibrateCamera(boards, left, size_, K1_, D1_, rotations, translations);
    cv::calibrateCamera(boards, right, size_, K2_, D2_, rotations, translations);
    rms_ = cv::stereoCalibrate(boards, left, right, K1_, D1_, K2_, D2_, size_, R_, T_, E_, F_, cv::CALIB_FIX_INTRINSIC);
    cv::stereoRectify(K1_, D1_, K2_, D2_, size_, R_, T_, R1_, R2_, P1_, P2_, Q_, cv::CALIB_ZERO_DISPARITY, 0.0);
  }

  // As a user's script writes it.
  std::string write_calibration(double unit = 1.0) const {
    const std::string path = folder_.file("stereo.yml");
    cv::FileStorage file(path, cv::FileStorage::WRITE);
    cv::Mat P2 = P2_.clone();
    P2.at<double>(0, 3) /= unit;
    file << "image_width" << size_.width << "image_height" << size_.height << "rms" << rms_;
    file << "K1" << K1_ << "D1" << D1_ << "K2" << K2_ << "D2" << D2_ << "R" << R_ << "T" << cv::Mat(T_ / unit);
    file << "E" << E_ << "F" << F_ << "R1" << R1_ << "R2" << R2_ << "P1" << P1_ << "P2" << P2 << "Q" << Q_;
    return path;
  }

  CommandResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--left",    OPENCV_EXAMPLES "/left%02d.jpg",
                                       "--right",   OPENCV_EXAMPLES "/right%02d.jpg",
                                       "--lcm-out", "file://" + log() + "?mode=w"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_stereo_camera(arguments);
  }
  std::string log() const { return folder_.file("out.lcm"); }

  static cv::Size size_;
  static RowError raw_;
  static double rms_;
  static cv::Mat K1_, D1_, K2_, D2_, R_, T_, E_, F_, R1_, R2_, P1_, P2_, Q_;
  test::TemporaryFolder folder_;
};

cv::Size RealCameras::size_;
RowError RealCameras::raw_;
double RealCameras::rms_ = 0.0;
cv::Mat RealCameras::K1_, RealCameras::D1_, RealCameras::K2_, RealCameras::D2_, RealCameras::R_, RealCameras::T_,
    RealCameras::E_, RealCameras::F_, RealCameras::R1_, RealCameras::R2_, RealCameras::P1_, RealCameras::P2_,
    RealCameras::Q_;

TEST_F(RealCameras, RectifiedShowEveryCornerOnTheSameRow) {
  const CommandResult result = run({"--calibration", write_calibration()});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(kPairs));
  RowErrorSum sum;
  for (const StereoFrame& frame : frames) {
    const cv::Size size(frame.width, frame.height);
    cv::Mat left(size, CV_8UC3);
    cv::Mat right(size, CV_8UC3);
    std::copy(frame.left.begin(), frame.left.end(), left.data);
    std::copy(frame.right.begin(), frame.right.end(), right.data);
    sum.add(left, right);
  }
  const RowError rectified = sum.result();
  RecordProperty("calibration_rms_px", std::to_string(rms_));
  RecordProperty("raw_row_rms_px", std::to_string(raw_.rms_px));
  RecordProperty("rectified_row_rms_px", std::to_string(rectified.rms_px));
  RecordProperty("boards", rectified.boards);
  EXPECT_GE(rectified.boards, kPairs - 2);  // a board may be cut off at the rectified picture's border
  EXPECT_GT(raw_.rms_px, 5.0) << "the raw pictures are rectified already: this test would prove nothing";
  EXPECT_LT(rectified.rms_px, 0.5);
}

TEST_F(RealCameras, PublishTheRectifiedCamerasInMetres) {
  ASSERT_EQ(run({"--calibration", write_calibration(), "--once"}).exit_code, 0);
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 1U);
  const auto& published = frames[0].calibration;
  EXPECT_NEAR(published.fx, P1_.at<double>(0, 0), 1e-9);
  EXPECT_NEAR(published.fy, P1_.at<double>(1, 1), 1e-9);
  EXPECT_NEAR(published.cx_left, P1_.at<double>(0, 2), 1e-9);
  EXPECT_NEAR(published.cx_right, P2_.at<double>(0, 2), 1e-9);
  EXPECT_NEAR(published.cy, P1_.at<double>(1, 2), 1e-9);
  EXPECT_NEAR(published.baseline, cv::norm(T_), 1e-9);
  EXPECT_GT(published.baseline, 0.05);
  EXPECT_LT(published.baseline, 0.15);
}

TEST_F(RealCameras, MayBeCalibratedInSquaresOfTheBoard) {
  const std::string path = write_calibration(kSquare_m);
  for (const char* option : {"--board-square", "--metres-per-unit"}) {
    ASSERT_EQ(run({"--calibration", path, "--once", option, "0.025"}).exit_code, 0);
    const auto frames = read_frames(log());
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_NEAR(frames[0].calibration.baseline, cv::norm(T_), 1e-6);
  }
}

}  // namespace
}  // namespace markservo::stereo_camera
