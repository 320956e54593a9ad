#include "services/mark-detector/learning/colour_learning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/learning/learning_check.hpp"
#include "tests/scenes/learning_draws.hpp"
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

scenes::GlossyBall blue_ball_before_a_bluish_wall(double highlight_share) {
  scenes::GlossyBall ball;
  ball.body = bgr_of(215.0, 0.8, 190.0);
  ball.wall = bgr_of(205.0, 0.3, 190.0);
  ball.to_lamp = {0.3, -0.3, std::sqrt(0.82)};
  ball.highlight_share = highlight_share;
  return ball;
}

const std::vector<robot::MarkDescription> kOneMark(1);

TEST(ColourLearning, KeepsTheWallOutBehindAGlossyBall) {
  for (const double highlight : {0.0, 0.01, 0.03, 0.08, 0.1}) {
    const scenes::LearningDraw draw =
        scenes::learn_from(blue_ball_before_a_bluish_wall(highlight), {4, -5}, kOneMark, 0, 1);
    EXPECT_EQ(draw.failure + draw.warning, "") << highlight;
    EXPECT_GT(draw.learned.saturation_min, 0.35) << highlight;
    EXPECT_GT(draw.overlap, 0.8) << highlight;
  }
}

TEST(ColourLearning, FindsBallsBeforeWallsOfNearHue) {
  constexpr int kDraws = 20;
  int good = 0;
  for (const scenes::LearningDraw& draw : scenes::draw_learning(kOneMark, 0, kDraws, 501)) {
    good += draw.overlap >= 0.8 ? 1 : 0;
    EXPECT_TRUE(draw.overlap >= 0.5 || !draw.failure.empty() || !draw.warning.empty()) << draw.seed;
  }
  EXPECT_GE(good, 19);
}

TEST(ColourLearning, TellsAPaleMarkFromAPurerWall) {
  scenes::GlossyBall ball = blue_ball_before_a_bluish_wall(0.03);
  std::swap(ball.body, ball.wall);
  const scenes::LearningDraw draw = scenes::learn_from(ball, {-3, 3}, kOneMark, 0, 1);
  EXPECT_LT(draw.learned.saturation_max, 0.7);
  EXPECT_GT(draw.overlap, 0.8);
}

TEST(ColourLearning, KeepsItsMarginsWhereNothingAroundIsOfNearColour) {
  const LearningParameters parameters;
  const double saturation = hsv_of({kOrange.b, kOrange.g, kOrange.r}).saturation;
  for (const Colour& wall : {kGrey, kBlue}) {
    const LearnedColour learned = learn(picture_of(kOrange, wall));
    EXPECT_LE(learned.interval.saturation_min, parameters.saturation_share * saturation);
    EXPECT_TRUE(holds(learned.interval, hue_of(kOrange), parameters.hue_half_width_deg - 1.0));
    EXPECT_EQ(learned.interval.saturation_max, 1.0);
    EXPECT_EQ(learned.doubt, "");
  }
}

TEST(ColourLearning, SaysWhenOnlyBrightnessTellsTheMark) {
  const Colour dark_orange{10.0, 27.5, 50.0};
  EXPECT_NE(learn(picture_of(kOrange, dark_orange)).doubt.find("only brightness"), std::string::npos);
}

// Of a detector that has learned from the picture.
std::string doubt(const LearningPicture& example) {
  const LearnedColour learned = learn_colour({example}, {});
  EXPECT_EQ(learned.failure, "");
  std::vector<robot::MarkDescription> marks = kOneMark;
  marks.front().colour = learned.interval;
  return doubt_about_learning(MarkDetector(marks, {}), 0, example, learned.mark_px2.front());
}

TEST(LearningCheck, HasNoDoubtAboutAMarkInItsBox) {
  const Picture picture = picture_of(kOrange, kGrey);
  EXPECT_EQ(doubt({picture.view(), 32, 17, 56, 56}), "");
}

TEST(LearningCheck, SaysThatTheMarkOutgrowsItsBox) {
  const Picture picture = picture_of(kOrange, kOrange);
  EXPECT_NE(doubt({picture.view(), 32, 17, 56, 56}).find("outgrows the box"), std::string::npos);
}

TEST(LearningCheck, SaysThatTheMarkOutgrowsItsBoxThoughByLittle) {
  Picture picture(120, 90, kGrey);
  picture.fill(26, 11, 68, 68, kOrange);  // 6 px beyond the box on each side: half as much again
  picture.expose(1.0, 3.0);
  EXPECT_NE(doubt({picture.view(), 32, 17, 56, 56}).find("outgrows the box"), std::string::npos);
}

TEST(LearningCheck, HasNoDoubtAboutASquareWhoseBoxIsALittleOff) {
  Picture picture(120, 90, kGrey);
  picture.fill(40, 20, 40, 40, kOrange);
  picture.expose(1.0, 3.0);
  EXPECT_EQ(doubt({picture.view(), 45, 15, 40, 40}), "");
}

TEST(LearningCheck, SaysThatSomethingElseIsTakenForTheMark) {
  Picture picture(320, 90, kGrey);
  picture.draw({60.0, 45.0, 40.0, 0.3, kOrange, 0.2});
  picture.fill(200, 10, 70, 70, kOrange);
  picture.expose(1.0, 3.0);
  EXPECT_NE(doubt({picture.view(), 32, 17, 56, 56}).find("200,10,70,70, outside the box"), std::string::npos);
}

TEST(LearningCheck, SaysThatNothingOrTooLittleIsFound) {
  const Picture picture = picture_of(kOrange, kGrey);
  const LearningPicture example{picture.view(), 32, 17, 56, 56};
  const LearnedColour learned = learn_colour({example}, {});
  std::vector<robot::MarkDescription> marks = kOneMark;
  marks.front().colour = {100.0, 140.0, 0.3, 1.0, 0.1, 1.0};
  EXPECT_NE(doubt_about_learning(MarkDetector(marks, {}), 0, example, learned.mark_px2.front()).find("not found"),
            std::string::npos);
  marks.front().colour = learned.interval;
  EXPECT_NE(doubt_about_learning(MarkDetector(marks, {}), 0, example, 4000.0).find("of it is found"),
            std::string::npos);
}

}  // namespace
}  // namespace markservo::mark_detector
