#include "services/stereo-camera/files/offset_estimate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/files/video_offset.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::HasSubstr;

// Where a thing is at a time (s), px.
using Path = std::function<double(double time_s)>;

// From one place to the next at random times, as a hand moves.
Path hand_movement(unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::pair<double, double>> moves;  // when, by how many px
  double place_px = 0.0;
  for (double time_s = -8.0; time_s < 40.0; time_s += std::uniform_real_distribution<double>(0.3, 1.5)(random)) {
    const double next_px = std::uniform_real_distribution<double>(-25.0, 25.0)(random);
    moves.emplace_back(time_s, next_px - place_px);
    place_px = next_px;
  }
  return [moves](double time_s) {
    double place = 0.0;
    for (const auto& [at, px] : moves) place += px / (1.0 + std::exp(-12.0 * (time_s - at)));
    return place;
  };
}

struct View {
  double begin_s = 0.0;  // scene time of the first picture
  double rate_hz = 30.0;
  int count = 300;
  double place_px = 0.0;  // where the camera sees what the other one sees at 0
  unsigned seed = 1;      // of its noise
};

// The motion of a red square before a grey wall that a camera with noise of 4 grey levels sees. Times count from its
// first picture.
std::vector<MotionStep> seen(const Path& path, const View& view) {
  MotionMeter meter;
  cv::RNG random(view.seed);
  for (int i = 0; i < view.count; ++i) {
    const double time_s = i / view.rate_hz;
    const double u = 80.0 + view.place_px + path(view.begin_s + time_s);
    cv::Mat picture(60, 160, CV_8UC3, cv::Scalar::all(60));
    constexpr int kShift = 4;  // sixteenths of a px
    const auto fixed = [](double px) { return static_cast<int>(std::lround(16.0 * px)); };
    cv::rectangle(picture, cv::Point(fixed(u - 7.5), fixed(15.0)), cv::Point(fixed(u + 7.5), fixed(45.0)),
                  cv::Scalar(40, 60, 220), cv::FILLED, cv::LINE_AA, kShift);
    cv::Mat noise(picture.size(), CV_16SC3);
    random.fill(noise, cv::RNG::NORMAL, 0.0, 4.0);
    cv::add(picture, noise, picture, cv::noArray(), CV_8UC3);
    meter.add(picture, time_s);
  }
  return meter.steps();
}

TEST(OffsetEstimate, FindsAPartOfAFramesPeriod) {
  unsigned seed = 0;
  for (const double offset_s : {-1.237, -0.013, 0.0, 0.313, 4.02}) {
    const Path path = hand_movement(++seed);
    // A camera that began earlier has more on its clock.
    const OffsetEstimate estimate =
        estimate_offset(seen(path, {0.0, 30.0, 300, 0.0, 1}), seen(path, {-offset_s, 30.0, 300, -12.0, 2}), {});
    EXPECT_EQ(estimate.status, OffsetStatus::kFound) << offset_s;
    EXPECT_NEAR(estimate.offset_s, offset_s, 0.5 / 30.0);
    EXPECT_GT(estimate.correlation, 0.8);
  }
}

TEST(OffsetEstimate, HoldsForCamerasOfTwoRatesAndLostPictures) {
  const Path path = hand_movement(3);
  std::vector<MotionStep> left = seen(path, {0.0, 30.0, 300, 0.0, 1});
  left.erase(left.begin() + 40, left.begin() + 60);
  const OffsetEstimate estimate = estimate_offset(left, seen(path, {-0.75, 24.0, 240, -12.0, 2}), {});
  EXPECT_EQ(estimate.status, OffsetStatus::kFound);
  EXPECT_NEAR(estimate.offset_s, 0.75, 0.5 / 24.0);
}

TEST(OffsetEstimate, IsNoneWhereNothingMoves) {
  const Path still = [](double) { return 0.0; };
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const OffsetEstimate estimate =
        estimate_offset(seen(still, {0.0, 30.0, 90, 0.0, seed}), seen(still, {0.0, 30.0, 90, 0.0, 100 + seed}), {});
    EXPECT_EQ(estimate.status, OffsetStatus::kTooLittle) << "seed " << seed << ": " << estimate.correlation;
  }
}

TEST(OffsetEstimate, IsNoneWhereTheTwoSeeDifferentThingsMove) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const OffsetEstimate estimate = estimate_offset(seen(hand_movement(seed), {0.0, 30.0, 300, 0.0, 1}),
                                                    seen(hand_movement(100 + seed), {0.0, 30.0, 300, 0.0, 2}), {});
    EXPECT_NE(estimate.status, OffsetStatus::kFound) << "seed " << seed << ": " << estimate.correlation;
  }
}

TEST(OffsetEstimate, IsNoneWhereTheMotionRepeatsItself) {
  const Path pendulum = [](double time_s) { return 20.0 * std::sin(6.0 * time_s); };
  const OffsetEstimate estimate =
      estimate_offset(seen(pendulum, {0.0, 30.0, 300, 0.0, 1}), seen(pendulum, {-0.2, 30.0, 300, -12.0, 2}), {});
  EXPECT_EQ(estimate.status, OffsetStatus::kAmbiguous);
}

TEST(OffsetEstimate, IsNoneOfAHandfulOfPictures) {
  const Path path = hand_movement(7);
  EXPECT_EQ(estimate_offset({}, {}, {}).status, OffsetStatus::kTooShort);
  const auto few = seen(path, {0.0, 30.0, 6, 0.0, 1});
  EXPECT_EQ(estimate_offset(few, few, {}).status, OffsetStatus::kTooShort);
}

TEST(MotionMeter, TakesAChangeOfExposureForNoMotion) {
  MotionMeter meter;
  cv::Mat picture(48, 64, CV_8UC3);
  cv::randu(picture, 50, 150);
  meter.add(picture, 0.0);
  meter.add(picture + cv::Scalar::all(40), 0.1);
  EXPECT_NEAR(meter.steps().at(0).rate, 0.0, 1e-3);
  EXPECT_THROW(meter.add(picture, 0.1), std::invalid_argument);
  EXPECT_THROW(meter.add(cv::Mat(), 0.2), std::invalid_argument);
}

class StillStream : public ImageStream {
 public:
  StreamResult next() override {
    if (position_ == 60) return {};
    return {StreamStatus::kImage, cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(90)), 33'333 * position_++, ""};
  }
  void rewind() override { position_ = 0; }
  double rate() const override { return 30.0; }

 private:
  std::int64_t position_ = 0;
};

TEST(VideoOffset, OfAStillSceneIsRefusedWithWhatToDo) {
  StillStream left;
  StillStream right;
  try {
    measure_offset(left, right);
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("too little moves"), HasSubstr("--offset-s")));
  }
}

}  // namespace
}  // namespace markservo::stereo_camera
