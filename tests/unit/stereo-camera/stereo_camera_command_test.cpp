// The executable: pictures in, a log out, and what it says to bad input.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <markservo/StereoFrame.hpp>
#include <opencv2/imgcodecs.hpp>

#include "calibration_text.hpp"
#include "command.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::HasSubstr;

cv::Mat noise(cv::Size size, int seed) {
  cv::RNG random(static_cast<std::uint64_t>(seed));
  cv::Mat image(size, CV_8UC3);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

class StereoCameraCommand : public testing::Test {
 protected:
  std::string picture(const std::string& name, cv::Size size, int seed) const {
    std::string path = folder_.file(name);
    cv::imwrite(path, noise(size, seed));
    return path;
  }

  // left_0..n-1.png and right_0..n-1.png of 64 x 48 px.
  void sequence(int n) const {
    for (int i = 0; i < n; ++i) {
      picture("left_" + std::to_string(i) + ".png", cv::Size(64, 48), 10 + i);
      picture("right_" + std::to_string(i) + ".png", cv::Size(64, 48), 20 + i);
    }
  }

  // Runs it on the sequence with `more` arguments; the log is in log().
  CommandResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"--left",    folder_.file("left_%d.png"),
                                       "--right",   folder_.file("right_%d.png"),
                                       "--lcm-out", "file://" + log() + "?mode=w"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_stereo_camera(arguments);
  }
  CommandResult run_plain(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--lcm-out", "file://" + log() + "?mode=w"});
    return run_stereo_camera(arguments);
  }
  std::string log() const { return folder_.file("out.lcm"); }

  static void expect_refused(const CommandResult& result, const std::vector<std::string>& words) {
    EXPECT_EQ(result.exit_code, 2) << result.output;
    for (const std::string& word : words) EXPECT_THAT(result.output, HasSubstr(word));
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << "not one line: " << result.output;
  }

  test::TemporaryFolder folder_;
  const std::vector<std::string> any_size_{"--fx", "50", "--baseline", "0.1"};
};

TEST_F(StereoCameraCommand, WritesEveryPairOnceAndEnds) {
  sequence(3);
  const CommandResult result = run({"--fx", "50", "--baseline", "0.1", "--rate", "20"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 3U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].seq, static_cast<std::int64_t>(i) + 1);
    EXPECT_EQ(frames[i].utime, 1'600'000'000'000'000 + 50'000 * static_cast<std::int64_t>(i));
    EXPECT_EQ(frames[i].encoding, StereoFrame::ENCODING_BGR8);
    EXPECT_EQ(frames[i].width, 64);
    EXPECT_EQ(frames[i].height, 48);
    EXPECT_EQ(frames[i].calibration.cx_left, 31.5);
    const cv::Mat expected = noise(cv::Size(64, 48), 20 + static_cast<int>(i));
    EXPECT_TRUE(std::equal(frames[i].right.begin(), frames[i].right.end(), expected.datastart, expected.dataend));
  }
}

TEST_F(StereoCameraCommand, WritesTheSameBytesAgain) {
  sequence(3);
  ASSERT_EQ(run(any_size_).exit_code, 0);
  const auto first = read_events(log());
  ASSERT_EQ(run(any_size_).exit_code, 0);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_TRUE(first == read_events(log()));
}

TEST_F(StereoCameraCommand, WritesJpegWhenTold) {
  sequence(1);
  ASSERT_EQ(run({"--fx", "50", "--baseline", "0.1", "--encoding", "jpeg", "--jpeg-quality", "95"}).exit_code, 0);
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].encoding, StereoFrame::ENCODING_JPEG);
  EXPECT_EQ(cv::imdecode(frames[0].left, cv::IMREAD_COLOR).size(), cv::Size(64, 48));
}

TEST_F(StereoCameraCommand, StopsAfterTheCountAndLoopsUpToIt) {
  sequence(2);
  ASSERT_EQ(run({"--fx", "50", "--baseline", "0.1", "--loop", "--count", "5"}).exit_code, 0);
  EXPECT_EQ(read_frames(log()).size(), 5U);
  ASSERT_EQ(run({"--fx", "50", "--baseline", "0.1", "--once"}).exit_code, 0);
  EXPECT_EQ(read_frames(log()).size(), 1U);
}

TEST_F(StereoCameraCommand, SplitsOnePictureWithBothViews) {
  const std::string both = picture("both.png", cv::Size(128, 48), 1);
  ASSERT_EQ(run_plain({"--input", both, "--side-by-side", "--fx", "50", "--baseline", "0.1"}).exit_code, 0);
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].width, 64);
  const cv::Mat expected = noise(cv::Size(128, 48), 1).colRange(64, 128).clone();
  EXPECT_TRUE(std::equal(frames[0].right.begin(), frames[0].right.end(), expected.datastart, expected.dataend));
}

TEST_F(StereoCameraCommand, DropsAndCountsBadPairsDuringARun) {
  sequence(4);
  folder_.write("left_1.png", "not a picture");
  picture("right_2.png", cv::Size(32, 48), 1);
  const CommandResult result = run(any_size_);
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("published 2 pairs, dropped 2"));
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[1].utime, 1'600'000'000'300'000) << "a dropped pair must not shift the others in time";
}

TEST_F(StereoCameraCommand, SaysWhichPicturesHaveNoPartner) {
  sequence(3);
  std::remove(folder_.file("right_2.png").c_str());
  const CommandResult result = run(any_size_);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("left has 3 pictures, right has 2; only the 2 with a partner are used"));
  EXPECT_EQ(read_frames(log()).size(), 2U);
}

TEST_F(StereoCameraCommand, RefusesAFirstPairOfDifferentSizes) {
  sequence(2);
  picture("right_0.png", cv::Size(32, 48), 1);
  expect_refused(run(any_size_), {"left picture is 64 x 48 px", "right picture is 32 x 48 px", "allowed"});
}

TEST_F(StereoCameraCommand, RefusesPicturesOfAnotherSizeThanRobotYaml) {
  sequence(1);
  expect_refused(run({}), {"64 x 48 px", "640 x 480 px", "robot.yaml"});
}

TEST_F(StereoCameraCommand, RefusesPicturesOfAnotherSizeThanTheCalibration) {
  sequence(1);
  const std::string path =
      folder_.write("stereo.yml", CalibrationText().set("image_width", "32").set("image_height", "24").text());
  expect_refused(run({"--calibration", path}), {"64 x 48 px", "32 x 24 px", "stereo.yml"});
}

TEST_F(StereoCameraCommand, RefusesUnreadablePictures) {
  sequence(1);
  folder_.write("left_0.png", "not a picture");
  expect_refused(run(any_size_), {"left_0.png", "not a readable picture"});
}

TEST_F(StereoCameraCommand, RefusesAPatternThatMatchesNothing) {
  expect_refused(run(any_size_), {"--left", "left_%d.png", "no file matches"});
}

TEST_F(StereoCameraCommand, RefusesADeviceThatIsNotThere) {
  expect_refused(run_plain({"--left-device", folder_.file("video0"), "--right-device", folder_.file("video2")}),
                 {"video0", "there is no such device"});
  expect_refused(run_plain({"--device", folder_.file("video0"), "--side-by-side"}), {"there is no such device"});
}

TEST_F(StereoCameraCommand, RefusesARateOfZeroOrLess) {
  sequence(1);
  expect_refused(run({"--fx", "50", "--baseline", "0.1", "--rate", "0"}), {"--rate", "allowed: 0.001 to 1000"});
  expect_refused(run({"--fx", "50", "--baseline", "0.1", "--rate", "-5"}), {"--rate", "allowed: 0.001 to 1000"});
}

TEST_F(StereoCameraCommand, RefusesALogWithoutEnd) {
  sequence(1);
  expect_refused(run({"--fx", "50", "--baseline", "0.1", "--loop"}), {"--loop", "--count"});
}

TEST_F(StereoCameraCommand, SaysInOneLineWhichCamerasItHas) {
  sequence(1);
  EXPECT_THAT(run(any_size_).output,
              HasSubstr("cameras: f 50.0 px, baseline 0.1000 m; pictures are taken as rectified"));
  const std::string path = folder_.write("stereo.yml", CalibrationText().text());
  EXPECT_THAT(run({"--calibration", path}).output,
              HasSubstr("cameras: f 50.0 px, baseline 0.1000 m; 100% of the rectified pictures show something, 100% of "
                        "the cameras' pictures are left"));
}

TEST_F(StereoCameraCommand, RefusesABaselineOf65MetresWhereverItIsGiven) {
  sequence(1);
  expect_refused(run({"--fx", "50", "--baseline", "65"}), {"--baseline is 65 m", "0.001 to 2 m"});
  const std::string T = matrix_text(3, 1, {"-65.", "0.", "0."});
  const CalibrationText rectified = CalibrationText().set("T", T).set("P2", CalibrationText::projection("-3250."));
  CalibrationText raw = rectified;
  for (const char* key : {"R1", "R2", "P1", "P2"}) raw.remove(key);
  for (const CalibrationText& text : {rectified, raw}) {
    expect_refused(run({"--calibration", folder_.write("stereo.yml", text.text())}),
                   {"stereo.yml", "baseline of 65 m", "--metres-per-unit 0.001 for mm", "--board-square"});
  }
}

TEST_F(StereoCameraCommand, AsksACalibrationBeforePicturesAreThere) {
  const std::string turn = matrix_text(3, 3, {"0.5", "0.", "-0.8660254", "0.", "1.", "0.", "0.8660254", "0.", "0.5"});
  const std::string path = folder_.write("stereo.yml", CalibrationText().set("R1", turn).text());
  sequence(1);
  const CommandResult result = run({"--calibration", path, "--check"});
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_THAT(result.output, HasSubstr("are they of one calibration"));
}

TEST_F(StereoCameraCommand, RefusesACalibrationWithAnErrorInItsSyntax) {
  sequence(1);
  const std::string path = folder_.write("stereo.yml", "%YAML:1.0\n---\nK1: [ 1, 2\nK2: ]\n");
  expect_refused(run({"--calibration", path}), {"stereo.yml: line "});
}

TEST_F(StereoCameraCommand, RefusesACalibrationWithASingularMatrix) {
  sequence(1);
  const std::string zeros = matrix_text(3, 3, std::vector<std::string>(9, "0."));
  const std::string path = folder_.write("stereo.yml", CalibrationText().set("K1", zeros).text());
  expect_refused(run({"--calibration", path}), {"stereo.yml", "K1", "singular"});
}

TEST_F(StereoCameraCommand, RefusesACalibrationWithoutAKey) {
  sequence(1);
  const std::string path = folder_.write("stereo.yml", CalibrationText().remove("P2").text());
  expect_refused(run({"--calibration", path}), {"stereo.yml", "P2", "missing"});
}

TEST_F(StereoCameraCommand, PublishesTheCamerasOfTheCalibration) {
  sequence(1);
  const std::string path = folder_.write("stereo.yml", CalibrationText().text());
  const CommandResult result = run({"--calibration", path});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_DOUBLE_EQ(frames[0].calibration.fx, 50.0);
  EXPECT_DOUBLE_EQ(frames[0].calibration.baseline, 0.1);
}

// What a file of another tool should lead to.
struct ForeignFile {
  std::vector<std::string> arguments;
  cv::Size pictures;
  double f_px, f_tolerance_px, baseline_m;
};

TEST_F(StereoCameraCommand, PublishesTheCamerasOfOtherToolsCalibrations) {
  const std::string data = MARKSERVO_SOURCE_DIR "/tests/data/";
  const std::vector<ForeignFile> files{
      {{data + "calibration/T-as-list.yml"}, {640, 480}, 500.0, 0.5, 0.06},
      {{data + "calibration/rational-no-rectification.yml"}, {1280, 720}, 704.0, 15.0, 0.12},
      {{data + "calibration/fisheye.yml", "--lens", "fisheye"}, {640, 480}, 216.55, 0.01, 0.064},
      {{data + "ros/left.yaml", data + "ros/right.yaml"}, {640, 480}, 600.0, 1e-9, 0.06}};
  for (const ForeignFile& file : files) {
    const std::string left = picture("left.png", file.pictures, 1);
    const std::string right = picture("right.png", file.pictures, 2);
    std::vector<std::string> arguments{"--left", left, "--right", right, "--calibration"};
    arguments.insert(arguments.end(), file.arguments.begin(), file.arguments.end());
    const CommandResult result = run_plain(arguments);
    ASSERT_EQ(result.exit_code, 0) << result.output;
    const auto frames = read_frames(log());
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_NEAR(frames[0].calibration.fx, file.f_px, file.f_tolerance_px) << file.arguments.front();
    EXPECT_NEAR(frames[0].calibration.baseline, file.baseline_m, 1e-9) << file.arguments.front();
  }
}

TEST_F(StereoCameraCommand, ReadsVideos) {
  const std::string video = OPENCV_EXAMPLES "/vtest.avi";
  const CommandResult result =
      run_plain({"--left", video, "--right", video, "--count", "3", "--fx", "700", "--baseline", "0.1"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto frames = read_frames(log());
  ASSERT_EQ(frames.size(), 3U);
  EXPECT_EQ(frames[0].width, 768);
  EXPECT_EQ(frames[2].utime - frames[0].utime, 200'000);  // the file states 10 frames a second
}

TEST_F(StereoCameraCommand, TakesItsSettingsFromAFile) {
  sequence(2);
  const std::string config = folder_.write("camera.ini", "fx=50\nbaseline=0.1\ncount=1\n");
  ASSERT_EQ(run({"--config", config}).exit_code, 0);
  EXPECT_EQ(read_frames(log()).size(), 1U);
}

}  // namespace
}  // namespace markservo::stereo_camera
