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
#include "temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::HasSubstr;

// Plays images that hold their own number; an empty one counts as unreadable.
class FakeStream : public ImageStream {
 public:
  explicit FakeStream(std::vector<cv::Mat> images) : images_(std::move(images)) {}
  StreamResult next() override {
    if (position_ == images_.size()) return {};
    const cv::Mat& image = images_[position_++];
    return image.empty() ? StreamResult{StreamStatus::kUnreadable, {}, "fake: not readable"}
                         : StreamResult{StreamStatus::kImage, image, ""};
  }
  void rewind() override { position_ = 0; }
  double rate() const override { return 0.0; }

 private:
  std::vector<cv::Mat> images_;
  std::size_t position_ = 0;
};

cv::Mat grey(int value, int width = 4) {
  return cv::Mat(2, width, CV_8UC3, cv::Scalar::all(value));
}

std::unique_ptr<ImageStream> stream(std::vector<cv::Mat> images) {
  return std::make_unique<FakeStream>(std::move(images));
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
  const TemporaryFolder folder;
  const std::string broken = folder.write("a.png", "not a picture");
  const std::string good = folder.file("b.png");
  ASSERT_TRUE(cv::imwrite(good, grey(5)));
  PictureStream pictures({broken, folder.file("absent.png"), good});
  EXPECT_EQ(pictures.next().status, StreamStatus::kUnreadable);
  EXPECT_EQ(pictures.next().status, StreamStatus::kUnreadable);
  const StreamResult result = pictures.next();
  ASSERT_EQ(result.status, StreamStatus::kImage);
  EXPECT_EQ(value(result.image), 5);
  EXPECT_EQ(pictures.next().status, StreamStatus::kEnd);
}

TEST(PictureStream, TurnsGreyPicturesIntoColour) {
  const TemporaryFolder folder;
  ASSERT_TRUE(cv::imwrite(folder.file("a.png"), cv::Mat(2, 4, CV_8UC1, cv::Scalar(9))));
  EXPECT_EQ(PictureStream({folder.file("a.png")}).next().image.type(), CV_8UC3);
}

TEST(VideoStream, ReadsEveryFrameAndTheRate) {
  VideoStream video(OPENCV_EXAMPLES "/vtest.avi", "--left");
  EXPECT_DOUBLE_EQ(video.rate(), 10.0);
  const StreamResult first = video.next();
  ASSERT_EQ(first.status, StreamStatus::kImage);
  EXPECT_EQ(first.image.size(), cv::Size(768, 576));
  const cv::Mat kept = first.image.clone();
  ASSERT_EQ(video.next().status, StreamStatus::kImage);
  EXPECT_EQ(cv::norm(first.image, kept, cv::NORM_INF), 0.0) << "a frame changed while the next was read";
  video.rewind();
  EXPECT_EQ(cv::norm(video.next().image, kept, cv::NORM_INF), 0.0);
}

TEST(VideoStream, RefusesWhatIsNoVideo) {
  const TemporaryFolder folder;
  EXPECT_THROW(VideoStream(folder.write("a.avi", "not a video"), "--left"), ConfigurationError);
  EXPECT_THROW(VideoStream(folder.file("absent.avi"), "--left"), ConfigurationError);
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
  const TemporaryFolder folder;
  options_.left = options_.right = folder.write("a.png", "");
  for (const double rate : {0.0, -1.0, 1e9, std::nan("")}) {
    options_.rate_hz = rate;
    EXPECT_THAT(error(), HasSubstr("--rate")) << rate;
  }
}

TEST_F(SourceChoice, OfVideosNeedsOneRate) {
  options_.left = OPENCV_EXAMPLES "/vtest.avi";
  options_.right = OPENCV_EXAMPLES "/tree.avi";
  EXPECT_THAT(error(), HasSubstr("the same rate"));
  options_.rate_hz = 10.0;
  EXPECT_EQ(error(), "");
}

TEST_F(SourceChoice, MayNotMixVideosAndPictures) {
  options_.left = "a.png";
  options_.right = "a.avi";
  EXPECT_THAT(error(), HasSubstr("both sides"));
}

}  // namespace
}  // namespace markservo::stereo_camera
