#include "services/stereo-camera/files/video_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/temporary_folder.hpp"
#include "video_file.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

cv::Mat grey(int value, cv::Size size = {32, 16}) {
  return cv::Mat(size, CV_8UC3, cv::Scalar::all(value));
}

std::vector<TimedImage> pictures_at(const std::vector<std::int64_t>& times_ms) {
  std::vector<TimedImage> pictures;
  for (const std::int64_t time_ms : times_ms)
    pictures.push_back({time_ms, grey(10 * static_cast<int>(pictures.size()))});
  return pictures;
}

class VideoFile : public testing::Test {
 protected:
  // The times of its pictures, ms.
  std::vector<std::int64_t> times_of(const std::string& name, std::optional<double> rate_hz = std::nullopt) const {
    VideoStream video(folder_.file(name), "--left", rate_hz);
    std::vector<std::int64_t> times;
    for (StreamResult result = video.next(); result.status == StreamStatus::kImage; result = video.next()) {
      times.push_back((result.time_us + 500) / 1000);
    }
    return times;
  }

  test::TemporaryFolder folder_;
};

TEST_F(VideoFile, GivesEveryFrameAndTheRate) {
  VideoStream video(OPENCV_EXAMPLES "/vtest.avi", "--left");
  EXPECT_DOUBLE_EQ(video.rate(), 10.0);
  const StreamResult first = video.next();
  ASSERT_EQ(first.status, StreamStatus::kImage);
  EXPECT_EQ(first.image.size(), cv::Size(768, 576));
  const cv::Mat kept = first.image.clone();
  const StreamResult second = video.next();
  ASSERT_EQ(second.status, StreamStatus::kImage);
  EXPECT_EQ(second.time_us - first.time_us, 100'000);
  EXPECT_EQ(cv::norm(first.image, kept, cv::NORM_INF), 0.0) << "a frame changed while the next was read";
  video.rewind();
  EXPECT_EQ(cv::norm(video.next().image, kept, cv::NORM_INF), 0.0);
}

TEST_F(VideoFile, OfPicturesWithoutTimesOfTheirOwnHasOnesThatRise) {
  VideoStream video(OPENCV_EXAMPLES "/Megamind.avi", "--left");  // states the time of every third only
  std::int64_t last_us = -1;
  int count = 0;
  for (StreamResult result = video.next(); result.status == StreamStatus::kImage; result = video.next(), ++count) {
    ASSERT_GT(result.time_us, last_us) << "picture " << count;
    last_us = result.time_us;
  }
  EXPECT_EQ(count, 270);
  EXPECT_NEAR(1e-6 * static_cast<double>(last_us), 270.0 / 23.976, 0.2);
}

TEST_F(VideoFile, GivesPicturesAsTheyWereWritten) {
  cv::Mat noise(18, 34, CV_8UC3);  // no multiple of what vector units write
  cv::randu(noise, 0, 256);
  write_video(folder_.file("a.mkv"), {{0, noise}});
  const StreamResult result = VideoStream(folder_.file("a.mkv"), "--left").next();
  ASSERT_EQ(result.status, StreamStatus::kImage);
  EXPECT_EQ(cv::norm(result.image, noise, cv::NORM_INF), 0.0);
}

TEST_F(VideoFile, KeepsItsGapsAndWhereItBegins) {
  write_video(folder_.file("gap.mkv"), pictures_at({200, 233, 267, 500, 533}));
  EXPECT_THAT(times_of("gap.mkv"), ElementsAre(200, 233, 267, 500, 533));
  write_video(folder_.file("gap.mp4"), pictures_at({200, 233, 267, 500, 533}));
  EXPECT_THAT(times_of("gap.mp4"), ElementsAre(200, 233, 267, 500, 533));
  write_video(folder_.file("gap.avi"), pictures_at({0, 100, 400, 500}), {10.0, {}});
  EXPECT_THAT(times_of("gap.avi"), ElementsAre(0, 100, 400, 500));
}

TEST_F(VideoFile, OfABroadcastBeginsAtZeroForItsClockBeganAnywhere) {
  std::vector<std::int64_t> times_ms{7000, 7040, 7120};
  for (int i = 0; i < 60; ++i) times_ms.push_back(7160 + 40 * i);  // a short one is not recognised
  write_video(folder_.file("a.ts"), pictures_at(times_ms), {25.0, {}});
  std::vector<std::int64_t> expected;
  for (const std::int64_t time_ms : times_ms) expected.push_back(time_ms - 7000);
  EXPECT_EQ(times_of("a.ts"), expected);
}

TEST_F(VideoFile, CountsItsPicturesByTheRateThatItIsGiven) {
  write_video(folder_.file("a.mkv"), pictures_at({200, 233, 500}));
  EXPECT_THAT(times_of("a.mkv", 10.0), ElementsAre(0, 100, 200));
}

TEST_F(VideoFile, IsShownUprightAsItsMatrixSays) {
  cv::Mat picture = grey(0, {32, 16});
  picture.colRange(16, 32).setTo(cv::Scalar::all(200));  // the right half is bright
  const std::int32_t one = 65536;
  write_video(folder_.file("a.mp4"), {{0, picture}}, {30.0, {0, -one, 0, one, 0, 0, 0, 0, 1 << 30}});
  const StreamResult result = VideoStream(folder_.file("a.mp4"), "--left").next();
  ASSERT_EQ(result.status, StreamStatus::kImage);
  ASSERT_EQ(result.image.size(), cv::Size(16, 32));
  EXPECT_GT(cv::mean(result.image.rowRange(2, 14))[0], 150.0) << "right goes up";
  EXPECT_LT(cv::mean(result.image.rowRange(18, 30))[0], 50.0);
}

TEST_F(VideoFile, IsRefusedWhereItIsNone) {
  for (const std::string& path : {folder_.write("a.avi", "not a video"), folder_.file("absent.avi")}) {
    try {
      VideoStream(path, "--left");
      FAIL() << path;
    } catch (const ConfigurationError& error) {
      EXPECT_THAT(error.what(), HasSubstr("--left is '" + path));
    }
  }
}

TEST_F(VideoFile, MayBeCutOffAndThenEndsEarly) {
  std::vector<TimedImage> pictures = pictures_at({0, 33, 67, 100, 133, 167});
  for (TimedImage& picture : pictures) cv::randu(picture.image, 0, 256);  // far larger than what stands before them
  write_video(folder_.file("whole.mkv"), pictures);
  std::ifstream whole(folder_.file("whole.mkv"), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(whole)), std::istreambuf_iterator<char>());
  folder_.write("cut.mkv", bytes.substr(0, bytes.size() / 2));
  const std::size_t left = times_of("cut.mkv").size();
  EXPECT_GT(left, 0U);
  EXPECT_LT(left, 6U);
}

// A playlist names other files; only what lies on this host is opened.
TEST_F(VideoFile, OpensNothingOnTheNetwork) {
  const std::string list = folder_.write("a.m3u8", "#EXTM3U\n#EXTINF:1,\nhttp://192.0.2.1/a.ts\n#EXT-X-ENDLIST\n");
  EXPECT_THROW(VideoStream(list, "--left"), ConfigurationError);
}

}  // namespace
}  // namespace markservo::stereo_camera
