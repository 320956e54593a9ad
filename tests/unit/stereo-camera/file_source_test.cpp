#include "services/stereo-camera/files/file_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/files/picture_stream.hpp"
#include "services/stereo-camera/files/video_stream.hpp"
#include "services/stereo-camera/source_options.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Plays images at given times (ms); an empty one counts as unreadable.
class FakeStream : public ImageStream {
 public:
  FakeStream(std::vector<cv::Mat> images, std::vector<std::int64_t> times_ms, double rate_hz)
      : images_(std::move(images)), times_ms_(std::move(times_ms)), rate_hz_(rate_hz) {}
  StreamResult next() override {
    if (position_ == images_.size()) return {};
    const cv::Mat& image = images_[position_];
    const std::int64_t time_us = 1000 * times_ms_[position_++];
    return image.empty() ? StreamResult{StreamStatus::kUnreadable, {}, time_us, "fake: not readable"}
                         : StreamResult{StreamStatus::kImage, image, time_us, ""};
  }
  void rewind() override { position_ = 0; }
  double rate() const override { return rate_hz_; }

 private:
  std::vector<cv::Mat> images_;
  std::vector<std::int64_t> times_ms_;
  double rate_hz_;
  std::size_t position_ = 0;
};

cv::Mat grey(int value, int width = 4) {
  return cv::Mat(2, width, CV_8UC3, cv::Scalar::all(value));
}

// At 10 pictures a second.
std::unique_ptr<ImageStream> stream(std::vector<cv::Mat> images) {
  std::vector<std::int64_t> times_ms;
  for (std::size_t i = 0; i < images.size(); ++i) times_ms.push_back(100 * static_cast<std::int64_t>(i));
  return std::make_unique<FakeStream>(std::move(images), std::move(times_ms), 10.0);
}

// Pictures at these times; each holds its time in periods of 10 ms.
std::unique_ptr<ImageStream> stream_at(const std::vector<std::int64_t>& times_ms, double rate_hz = 10.0) {
  std::vector<cv::Mat> images;
  for (const std::int64_t time_ms : times_ms) images.push_back(grey(static_cast<int>(time_ms / 10)));
  return std::make_unique<FakeStream>(std::move(images), times_ms, rate_hz);
}

int value(const cv::Mat& image) {
  return image.at<cv::Vec3b>(0, 0)[0];
}

TEST(FileSource, GivesPairsInOrderWithTheirNumbers) {
  FileSource source(stream({grey(1), grey(2)}), stream({grey(11), grey(12)}), false);
  for (int i = 0; i < 2; ++i) {
    const ReadResult result = source.read();
    ASSERT_EQ(result.status, ReadStatus::kPair);
    EXPECT_EQ(result.pair.index, i);
    EXPECT_EQ(value(result.pair.left), 1 + i);
    EXPECT_EQ(value(result.pair.right), 11 + i);
    EXPECT_FALSE(result.pair.exposure_utime);
  }
  EXPECT_EQ(source.read().status, ReadStatus::kEnd);
}

TEST(FileSource, AnUnreadablePictureCostsItsPairAndItsNumberOnly) {
  FileSource source(stream({grey(1), cv::Mat(), grey(3)}), stream({grey(11), grey(12), grey(13)}), false);
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
  const ReadResult dropped = source.read();
  EXPECT_EQ(dropped.status, ReadStatus::kDropped);
  EXPECT_EQ(dropped.reason, "fake: not readable");
  const ReadResult third = source.read();
  ASSERT_EQ(third.status, ReadStatus::kPair);
  EXPECT_EQ(third.pair.index, 2);
  EXPECT_EQ(value(third.pair.right), 13);
}

TEST(FileSource, StopsAtTheShorterSideAndSaysSo) {
  FileSource source(stream({grey(1), grey(2)}), stream({grey(11)}), false);
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
  const ReadResult end = source.read();
  EXPECT_EQ(end.status, ReadStatus::kEnd);
  EXPECT_THAT(end.reason, HasSubstr("right ends after 1 pictures"));
}

// "time: left/right" of every pair, ms, "-" for what was dropped, and why it ended.
std::string told(FileSource& source, int most = 100) {
  std::string text;
  for (int i = 0; i < most; ++i) {
    const ReadResult result = source.read();
    if (result.status == ReadStatus::kEnd) return text + result.reason;
    if (result.status == ReadStatus::kDropped) {
      text += "- ";
      continue;
    }
    text += std::to_string(result.pair.time_us / 1000) + ": " + std::to_string(10 * value(result.pair.left)) + "/" +
            std::to_string(10 * value(result.pair.right)) + " ";
  }
  return text;
}

TEST(FileSource, PairsByTimeWhereOneSideLostPictures) {
  FileSource source(stream_at({0, 100, 200, 300, 400, 500}), stream_at({0, 100, 400, 500}), false);
  EXPECT_EQ(told(source), "0: 0/0 100: 100/100 - - 400: 400/400 500: 500/500 ");
}

TEST(FileSource, LeavesAGapWhereBothSidesLostPictures) {
  FileSource source(stream_at({0, 100, 500}), stream_at({0, 100, 500}), false);
  EXPECT_EQ(told(source), "0: 0/0 100: 100/100 500: 500/500 ");
}

TEST(FileSource, GivesTheMiddleOfBothTimes) {
  FileSource source(stream_at({0, 100}), stream_at({20, 120}), false);
  EXPECT_EQ(told(source), "10: 0/20 110: 100/120 ");
}

TEST(FileSource, PairsTheNearestOfFreeRunningCameras) {
  FileSource source(stream_at({0, 100, 200, 300}), stream_at({60, 160, 260, 360}), false);
  EXPECT_THAT(told(source), HasSubstr("80: 100/60 180: 200/160 280: 300/260"));
}

TEST(FileSource, TakesTheNearerPictureThoughTheFirstIsNearEnough) {
  FileSource source(stream_at({0, 40, 140}), stream_at({50, 150}), false);
  EXPECT_THAT(told(source), HasSubstr("45: 40/50 145: 140/150"));
}

TEST(FileSource, TakesOfAFasterVideoThePicturesOfTheSlowerOnesTimes) {
  FileSource source(stream_at({0, 100, 200}, 10.0), stream_at({0, 50, 100, 150, 200, 250}, 20.0), false);
  EXPECT_THAT(told(source), HasSubstr("0: 0/0 - 100: 100/100 - 200: 200/200 "));
}

TEST(FileSource, ShiftsTheRightTimesByTheOffset) {
  FileSource source(stream_at({0, 100, 200, 300}), stream_at({500, 600, 700, 800}), false, 400'000);
  EXPECT_THAT(told(source), HasSubstr("100: 100/500 200: 200/600 300: 300/700 left ends after 4 pictures"));
}

TEST(FileSource, SaysHowMuchOfABeginningIsLeftOut) {
  FileSource source(stream_at({0, 100, 200}), stream_at({200, 300}), false);
  const ReadResult first = source.read();
  ASSERT_EQ(first.status, ReadStatus::kPair);
  EXPECT_EQ(first.reason, "before the first pair, 2 pictures of the left and 0 of the right are left out");
}

TEST(FileSource, SaysWhenTheTwoShareNoTime) {
  FileSource source(stream_at({0, 100}), stream_at({5000, 5100}), true);
  EXPECT_THAT(told(source), HasSubstr("none of the left's 2 pictures is within half a period (50 ms)"));
}

TEST(FileSource, LoopsWithTimesThatGoOn) {
  FileSource source(stream_at({200, 300}), stream_at({200, 300}), true);
  EXPECT_EQ(told(source, 5), "200: 200/200 300: 300/300 400: 200/200 500: 300/300 600: 200/200 ");
}

TEST(FileSource, LoopsWithNumbersThatGoOn) {
  FileSource source(stream({grey(1), grey(2)}), stream({grey(11), grey(12)}), true);
  for (int i = 0; i < 5; ++i) {
    const ReadResult result = source.read();
    ASSERT_EQ(result.status, ReadStatus::kPair);
    EXPECT_EQ(result.pair.index, i);
    EXPECT_EQ(value(result.pair.left), 1 + i % 2);
  }
}

TEST(FileSource, DoesNotLoopOverPicturesOfWhichNoneCanBeRead) {
  FileSource source(stream({cv::Mat()}), stream({grey(1)}), true);
  EXPECT_EQ(source.read().status, ReadStatus::kDropped);
  EXPECT_EQ(source.read().status, ReadStatus::kEnd);
}

TEST(FileSource, SplitsPicturesWithBothViews) {
  cv::Mat both = grey(1, 8);
  both.colRange(4, 8).setTo(cv::Scalar::all(2));
  FileSource source(stream({both, grey(1, 7)}), false);
  const ReadResult result = source.read();
  ASSERT_EQ(result.status, ReadStatus::kPair);
  EXPECT_EQ(value(result.pair.left), 1);
  EXPECT_EQ(value(result.pair.right), 2);
  EXPECT_EQ(result.pair.left.cols, 4);
  const ReadResult odd = source.read();
  EXPECT_EQ(odd.status, ReadStatus::kDropped);
  EXPECT_THAT(odd.reason, HasSubstr("even width"));
}

TEST(PairComplaint, NamesBothSizes) {
  EXPECT_EQ(pair_complaint(grey(1), grey(2), {}), "");
  EXPECT_EQ(pair_complaint(grey(1), grey(2), cv::Size(4, 2)), "");
  EXPECT_EQ(pair_complaint(grey(1), grey(2, 6), {}),
            "left picture is 4 x 2 px, right picture is 6 x 2 px; allowed: the same size");
  EXPECT_EQ(pair_complaint(grey(1), grey(2), cv::Size(8, 8)), "pictures are 4 x 2 px; allowed: 8 x 8 px");
  EXPECT_EQ(pair_complaint(grey(1), cv::Mat(), {}), "right picture is empty");
  EXPECT_NE(pair_complaint(cv::Mat(2, 4, CV_8UC1), grey(1), {}), "");
}

TEST(PictureStream, ReportsAFileThatIsNoPictureAndGoesOn) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const test::TemporaryFolder folder;
  const std::string broken = folder.write("a.png", "not a picture");
  const std::string good = folder.file("b.png");
  ASSERT_TRUE(cv::imwrite(good, grey(5)));
  PictureStream pictures({{0, broken}, {1, folder.file("absent.png")}, {4, good}}, 10.0);
  EXPECT_EQ(pictures.next().status, StreamStatus::kUnreadable);
  EXPECT_EQ(pictures.next().status, StreamStatus::kUnreadable);
  const StreamResult result = pictures.next();
  ASSERT_EQ(result.status, StreamStatus::kImage);
  EXPECT_EQ(value(result.image), 5);
  EXPECT_EQ(result.time_us, 400'000) << "what was lost leaves a gap";
  EXPECT_EQ(pictures.next().status, StreamStatus::kEnd);
}

TEST(PictureStream, TurnsGreyPicturesIntoColour) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(cv::imwrite(folder.file("a.png"), cv::Mat(2, 4, CV_8UC1, cv::Scalar(9))));
  EXPECT_EQ(PictureStream({{0, folder.file("a.png")}}, 10.0).next().image.type(), CV_8UC3);
}

class SourceChoice : public testing::Test {
 protected:
  std::string error() const {
    try {
      open_source(options_, cv::Size(640, 480));
    } catch (const ConfigurationError& problem) {
      return problem.what();
    }
    return "";
  }
  SourceOptions options_;
};

TEST_F(SourceChoice, MustBeMade) {
  EXPECT_THAT(error(), HasSubstr("no source"));
}

TEST_F(SourceChoice, MustBeOne) {
  options_.left_device = "/dev/video0";
  options_.input = "both.avi";
  EXPECT_THAT(error(), HasSubstr("mixed"));
}

TEST_F(SourceChoice, NeedsBothSides) {
  options_.left = "a.png";
  EXPECT_THAT(error(), HasSubstr("--right"));
  options_ = {};
  options_.right_device = "/dev/video0";
  EXPECT_THAT(error(), HasSubstr("--left-device"));
}

TEST_F(SourceChoice, NeedsTwoCamerasNotOneTwice) {
  options_.left_device = options_.right_device = "/dev/video0";
  EXPECT_THAT(error(), HasSubstr("two cameras"));
}

TEST_F(SourceChoice, OfOneCameraNeedsSideBySide) {
  options_.device = "/dev/video0";
  EXPECT_THAT(error(), HasSubstr("--side-by-side"));
}

TEST_F(SourceChoice, NeedsAPossibleRate) {
  const test::TemporaryFolder folder;
  options_.left = options_.right = folder.write("a.png", "");
  for (const double rate : {0.0, -1.0, 1e-15, 9e-4, 1e9, std::nan("")}) {
    options_.rate_hz = rate;
    EXPECT_THAT(error(), HasSubstr("--rate")) << rate;
  }
}

TEST_F(SourceChoice, OfVideosOfTwoRatesSaysSo) {
  options_.left = OPENCV_EXAMPLES "/vtest.avi";
  options_.right = OPENCV_EXAMPLES "/tree.avi";
  const OpenedSource opened = open_source(options_, cv::Size(640, 480));
  ASSERT_EQ(opened.warnings.size(), 1U);
  EXPECT_THAT(opened.warnings[0], AllOf(HasSubstr("--left has 10 pictures"), HasSubstr("--right 14.9999")));
  options_.rate_hz = 10.0;
  EXPECT_TRUE(open_source(options_, cv::Size(640, 480)).warnings.empty());
}

TEST_F(SourceChoice, HasAnOffsetOfTwoVideosOnly) {
  const test::TemporaryFolder folder;
  options_.left = options_.right = folder.write("a.png", "");
  options_.offset_s = 0.5;
  EXPECT_THAT(error(), HasSubstr("--offset-s is given without two videos"));
  options_.offset_s.reset();
  options_.estimate_offset = true;
  EXPECT_THAT(error(), HasSubstr("--estimate-offset is given without two videos"));
  options_ = {};
  options_.left = options_.right = OPENCV_EXAMPLES "/vtest.avi";
  options_.offset_s = std::nan("");
  EXPECT_THAT(error(), HasSubstr("--offset-s is nan"));
  options_.offset_s = 0.5;
  EXPECT_EQ(error(), "");
  options_.estimate_offset = true;
  EXPECT_THAT(error(), HasSubstr("both given"));
}

TEST_F(SourceChoice, MayNotMixVideosAndPictures) {
  options_.left = "a.png";
  options_.right = "a.avi";
  EXPECT_THAT(error(), HasSubstr("both sides"));
}

}  // namespace
}  // namespace markservo::stereo_camera
