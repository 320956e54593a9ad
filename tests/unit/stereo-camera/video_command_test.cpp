// The executable on pairs of videos: what is published shows one moment, at its time, upright.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "command.hpp"
#include "tests/unit/temporary_folder.hpp"
#include "video_file.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::int64_t kEpoch_us = 1'600'000'000'000'000;
constexpr double kDisparity_px = 30.0;  // of a mark at 0.6 m, for f = 300 px and a baseline of 0.06 m

// A grey picture with a red square whose left edge is at `u`.
cv::Mat picture_with_square(int u) {
  cv::Mat picture(120, 320, CV_8UC3, cv::Scalar::all(120));
  picture(cv::Rect(u, 40, 40, 40)).setTo(cv::Scalar(20, 20, 220));
  return picture;
}

// The mean column (or row) of what is red, px.
cv::Point2d red_centre(const std::vector<std::uint8_t>& bgr, int width, int height) {
  const cv::Mat picture(height, width, CV_8UC3, const_cast<std::uint8_t*>(bgr.data()));
  cv::Mat red;
  cv::inRange(picture, cv::Scalar(0, 0, 150), cv::Scalar(90, 90, 255), red);
  const cv::Moments moments = cv::moments(red, true);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

double disparity(const StereoFrame& frame) {
  return red_centre(frame.left, frame.width, frame.height).x - red_centre(frame.right, frame.width, frame.height).x;
}

std::vector<std::int64_t> times_ms(const std::vector<StereoFrame>& frames) {
  std::vector<std::int64_t> times;
  for (const StereoFrame& frame : frames) times.push_back((frame.utime - kEpoch_us + 500) / 1000);
  return times;
}

class VideoPair : public testing::Test {
 protected:
  // A square that moves by 10 px every 1/15 s, seen at these numbers of 1/15 s; a clock that is `ahead_ms` ahead.
  void write(const std::string& side, const std::vector<int>& numbers, int disparity_px, int ahead_ms = 0) const {
    std::vector<TimedImage> pictures;
    for (const int number : numbers) {
      pictures.push_back(
          {std::lround(number * 1000.0 / 15.0) + ahead_ms, picture_with_square(60 + 10 * number - disparity_px)});
    }
    write_video(folder_.file(side + ".mkv"), pictures, {15.0, {}});
  }

  CommandResult run(const std::vector<std::string>& more, const std::string& end = ".mkv") const {
    std::vector<std::string> arguments{"--left",     folder_.file("left" + end),
                                       "--right",    folder_.file("right" + end),
                                       "--lcm-out",  "file://" + log() + "?mode=w",
                                       "--encoding", "raw",
                                       "--fx",       "300",
                                       "--baseline", "0.06"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_stereo_camera(arguments);
  }
  std::string log() const { return folder_.file("out.lcm"); }

  void expect_every_disparity_right() const {
    for (const StereoFrame& frame : read_frames(log())) EXPECT_NEAR(disparity(frame), kDisparity_px, 0.01);
  }

  test::TemporaryFolder folder_;
};

TEST_F(VideoPair, ThatLostPicturesOnOneSideIsPairedByTimeAndTheGapStays) {
  write("left", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 0);
  write("right", {0, 1, 2, 3, 4, 8, 9}, 30);
  const CommandResult result = run({});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(times_ms(read_frames(log())), ElementsAre(0, 67, 133, 200, 267, 533, 600));
  expect_every_disparity_right();
  EXPECT_THAT(result.output, HasSubstr("published 7 pairs, dropped 3"));
  EXPECT_THAT(result.output, HasSubstr("taken for one clock's")) << "nobody has asked whether they are";
}

TEST_F(VideoPair, OfWhichEachLostOthersKeepsTheMomentsThatBothHave) {
  write("left", {0, 1, 4, 5, 6, 8, 9}, 0);
  write("right", {0, 2, 3, 4, 6, 7, 8, 9}, 30);
  ASSERT_EQ(run({}).exit_code, 0);
  EXPECT_THAT(times_ms(read_frames(log())), ElementsAre(0, 267, 400, 533, 600));
  expect_every_disparity_right();
}

TEST_F(VideoPair, OfWhichOneBeganLaterIsPairedByTime) {
  write("left", {3, 4, 5, 6, 7}, 0);
  write("right", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, 30);
  const CommandResult result = run({});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(times_ms(read_frames(log())), ElementsAre(200, 267, 333, 400, 467));
  expect_every_disparity_right();
  EXPECT_THAT(result.output, HasSubstr("before the first pair, 0 pictures of the left and 3 of the right"));
}

TEST_F(VideoPair, MayHaveClocksThatDifferByAStatedOffset) {
  write("left", {0, 1, 2, 3, 4}, 0);
  write("right", {0, 1, 2, 3, 4}, 30, 5000);
  EXPECT_THAT(run({}).output, HasSubstr("--estimate-offset where their clocks differ"));
  const CommandResult result = run({"--offset-s", "5"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(times_ms(read_frames(log())), ElementsAre(0, 67, 133, 200, 267));
  expect_every_disparity_right();
}

TEST_F(VideoPair, TellsItsOffsetByWhatMoves) {
  // Jumps at irregular moments; the right camera was switched on 400 ms later.
  const std::vector<int> places{40,  40,  70,  70,  70, 120, 120, 90,  90,  90,  90,  200, 200, 150, 150, 150, 230,
                                230, 60,  60,  60,  60, 100, 100, 100, 180, 180, 130, 130, 130, 130, 80,  80,  210,
                                210, 210, 210, 210, 70, 70,  110, 110, 110, 50,  50,  50,  50,  50,  190, 190};
  std::vector<TimedImage> left;
  std::vector<TimedImage> right;
  for (int i = 0; i < static_cast<int>(places.size()); ++i) {
    const int place = places[static_cast<std::size_t>(i)];
    left.push_back({std::int64_t{50} * i, picture_with_square(place)});
    if (i >= 8) right.push_back({std::int64_t{50} * (i - 8), picture_with_square(place - 30)});
  }
  write_video(folder_.file("left.mkv"), left, {20.0, {}});
  write_video(folder_.file("right.mkv"), right, {20.0, {}});
  const CommandResult result = run({"--estimate-offset"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const std::string option = ": --offset-s ";
  const std::size_t at = result.output.find(option);
  ASSERT_NE(at, std::string::npos) << result.output;
  EXPECT_LT(result.output.find("--estimate-offset: looking for what moves"), at) << "it takes its time";
  EXPECT_NEAR(std::stod(result.output.substr(at + option.size())), -0.4, 0.01);
  EXPECT_EQ(read_frames(log()).size(), 42U);
  expect_every_disparity_right();
}

TEST_F(VideoPair, InWhichNothingMovesDoesNotTellItsOffset) {
  write("left", std::vector<int>(20, 0), 0);
  std::vector<TimedImage> still;
  for (int i = 0; i < 20; ++i) still.push_back({std::int64_t{67} * i, picture_with_square(60)});
  for (const char* side : {"left.mkv", "right.mkv"}) write_video(folder_.file(side), still, {15.0, {}});
  const CommandResult result = run({"--estimate-offset"});
  EXPECT_EQ(result.exit_code, 2) << result.output;
  EXPECT_THAT(result.output, HasSubstr("too little moves"));
}

// How the sensors lay, and the matrix by which the video says so.
struct Turn {
  cv::RotateFlags sensor;
  std::int32_t a, b, c, d;  // display_matrix's, in 1/65536
};

TEST_F(VideoPair, FilmedWithTurnedCamerasIsShownUpright) {
  constexpr std::int32_t kOne = 65536;
  for (const Turn& turn :
       {Turn{cv::ROTATE_90_CLOCKWISE, 0, -kOne, kOne, 0}, Turn{cv::ROTATE_90_COUNTERCLOCKWISE, 0, kOne, -kOne, 0},
        Turn{cv::ROTATE_180, -kOne, 0, 0, -kOne}}) {
    for (const auto& [side, u] : {std::pair<std::string, int>{"left", 180}, {"right", 150}}) {
      cv::Mat sensor;
      cv::rotate(picture_with_square(u), sensor, turn.sensor);
      const std::vector<TimedImage> pictures{{0, sensor}, {100, sensor}};
      write_video(folder_.file(side + ".mp4"), pictures, {10.0, {turn.a, turn.b, 0, turn.c, turn.d, 0, 0, 0, 1 << 30}});
    }
    const CommandResult result = run({}, ".mp4");
    ASSERT_EQ(result.exit_code, 0) << result.output;
    const auto frames = read_frames(log());
    ASSERT_EQ(frames.size(), 2U);
    ASSERT_EQ(frames[0].width, 320) << turn.sensor;
    EXPECT_NEAR(disparity(frames[0]), 30.0, 0.5) << turn.sensor;
    EXPECT_NEAR(red_centre(frames[0].left, 320, 120).x, 199.5, 0.5) << turn.sensor;
    EXPECT_NEAR(red_centre(frames[0].left, 320, 120).y, 59.5, 0.5) << turn.sensor;
  }
}

TEST_F(VideoPair, CountsItsPicturesWhereARateIsGiven) {
  write("left", {0, 1, 2, 7}, 0);
  write("right", {0, 1, 2, 7}, 30);
  ASSERT_EQ(run({"--rate", "10"}).exit_code, 0);
  EXPECT_THAT(times_ms(read_frames(log())), ElementsAre(0, 100, 200, 300));
}

}  // namespace
}  // namespace markservo::stereo_camera
