#include "services/mark-detector/learning/colour_learning.hpp"

#include <gtest/gtest.h>

#include "services/mark-detector/colour/hue.hpp"
#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

constexpr Colour kOrange{40.0, 110.0, 200.0};

double hue_of(const Colour& colour) {
  return hsv_of({colour.b, colour.g, colour.r}).hue_deg;
}

// A picture of a mark, 40 px wide, at (60, 45) on a wall.
Picture picture_of(const Colour& mark, const Colour& wall, double gain = 1.0) {
  Picture picture(120, 90, wall);
  picture.draw({60.0, 45.0, 40.0, 0.3, mark, 0.2});
  picture.expose(gain, 3.0);
  return picture;
}

LearnedColour learn(const Picture& picture, int x = 32, int y = 17, int width = 56, int height = 56) {
  return learn_colour({{picture.view(), x, y, width, height}}, {});
}

bool holds(const robot::ColourInterval& interval, double hue, double margin) {
  const double width = wrapped(interval.hue_max_deg - interval.hue_min_deg);
  const double place = wrapped(hue - interval.hue_min_deg);
  return place >= margin && place <= width - margin;
}

TEST(ColourLearning, TakesTheMarksHueNotTheBackgroundInTheCorners) {
  for (const Colour& wall : {kGrey, kBlue}) {
    const LearnedColour learned = learn(picture_of(kOrange, wall));
    ASSERT_EQ(learned.failure, "");
    EXPECT_TRUE(holds(learned.interval, hue_of(kOrange), 10.0));
    EXPECT_FALSE(holds(learned.interval, hue_of(kBlue), 0.0));
    EXPECT_LT(wrapped(learned.interval.hue_max_deg - learned.interval.hue_min_deg), 50.0);
  }
}

TEST(ColourLearning, WrapsRedAroundZero) {
  const robot::ColourInterval interval = learn(picture_of(kRed, kGrey)).interval;
  EXPECT_GT(interval.hue_min_deg, 300.0);
  EXPECT_LT(interval.hue_max_deg, 60.0);
}

TEST(ColourLearning, LeavesRoomForLessAndForMoreLight) {
  const Hsv mark = hsv_of({kOrange.b, kOrange.g, kOrange.r});
  const robot::ColourInterval interval = learn(picture_of(kOrange, kGrey)).interval;
  EXPECT_LT(interval.saturation_min, 0.75 * mark.saturation);
  EXPECT_GT(interval.saturation_min, 0.3 * mark.saturation);
  EXPECT_LT(interval.value_min, 0.5 * mark.value / 255.0);
  EXPECT_EQ(interval.saturation_max, 1.0);
  EXPECT_EQ(interval.value_max, 1.0);
}

TEST(ColourLearning, SpansWhatSeveralPicturesShow) {
  const Picture first = picture_of(kOrange, kGrey);
  const Colour yellower{40.0, 135.0, 200.0};
  const Picture second = picture_of(yellower, kGrey, 0.5);
  const robot::ColourInterval interval =
      learn_colour({{first.view(), 40, 25, 40, 40}, {second.view(), 40, 25, 40, 40}}, {}).interval;
  EXPECT_TRUE(holds(interval, hue_of(kOrange), 5.0));
  EXPECT_TRUE(holds(interval, hue_of(yellower), 5.0));
}

TEST(ColourLearning, TakesAPureColourThatClips) {
  const LearnedColour learned = learn(picture_of({0.0, 0.0, 255.0}, kGrey), 45, 30, 30, 30);
  EXPECT_EQ(learned.failure, "");
  EXPECT_TRUE(holds(learned.interval, 0.0, 10.0));
}

TEST(ColourLearning, SaysWhyABoxHasNoHue) {
  const Picture picture = picture_of(kGrey, kWhite);
  EXPECT_NE(learn(picture).failure.find("has a hue"), std::string::npos);
  Picture patchwork(60, 60, kGrey);
  patchwork.fill(0, 0, 30, 30, kRed);
  patchwork.fill(30, 0, 30, 30, kGreen);
  patchwork.fill(0, 30, 30, 30, kBlue);
  patchwork.fill(30, 30, 30, 30, kYellow);
  patchwork.expose();
  EXPECT_NE(learn(patchwork, 0, 0, 60, 60).failure.find("no hue dominates"), std::string::npos);
}

TEST(ColourLearning, RefusesAMarkTooPaleToBeToldFromAWall) {
  const Colour pale_orange{205.0, 215.0, 228.0};
  EXPECT_NE(learn(picture_of(pale_orange, kGrey), 45, 30, 30, 30).failure.find("too pale"), std::string::npos);
}

}  // namespace
}  // namespace markservo::mark_detector
