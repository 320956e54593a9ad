#include "services/mark-detector/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

robot::MarkDescription red_mark() {
  robot::MarkDescription mark;
  mark.name = "red";
  mark.colour = {345.0, 15.0, 0.5, 1.0, 0.2, 1.0};
  return mark;
}

// White to the left of the mark, black to the right, grey above: an edge that is cut differently on every side.
Picture uneven_background(const Square& square) {
  Picture picture(160, 120, kBlack);
  picture.fill(0, 0, static_cast<int>(square.u), 120, kWhite);
  picture.fill(0, 0, 160, static_cast<int>(square.v - 0.4 * square.edge), kGrey);
  picture.draw(square);
  return picture;
}

struct Errors {
  double mean = 0.0;  // px
  double max = 0.0;
};

template <class Background>
Errors centroid_errors(double sigma, double gain, double texture, Background&& background) {
  const MarkDetector detector({red_mark()}, {});
  Errors errors;
  int n = 0;
  for (const double edge : {24.0, 45.3, 70.0}) {
    for (const double angle : {0.0, 0.1, 0.4, 0.7}) {
      const Square square{78.0 + 0.137 * n, 57.0 + 0.291 * (n % 4), edge, angle, kRed, texture};
      Picture picture = background(square);
      picture.expose(gain, sigma, static_cast<unsigned>(n + 1));
      State state;
      Input input;
      input.left = picture.view();
      const Output output = detector.step(input, state);
      const View& view = output.marks.at(0).left;
      EXPECT_TRUE(view.seen) << output.marks.at(0).reason;
      const double error = std::hypot(view.shape.u - square.u, view.shape.v - square.v);
      EXPECT_NEAR(std::sqrt(view.shape.area), edge, 0.25);
      errors.mean += error;
      errors.max = std::max(errors.max, error);
      ++n;
    }
  }
  errors.mean /= n;
  std::printf("centroid error: mean %.4f px, max %.4f px\n", errors.mean, errors.max);
  return errors;
}

Picture on_grey(const Square& square) {
  Picture picture(160, 120, kGrey);
  picture.draw(square);
  return picture;
}

TEST(Outline, FindsTheCentreToATwentiethOfAPixelWithoutNoise) {
  EXPECT_LT(centroid_errors(0.0, 1.0, 0.0, on_grey).max, 0.05);
  EXPECT_LT(centroid_errors(0.0, 1.0, 0.0, uneven_background).max, 0.05);
}

TEST(Outline, FindsTheCentreToATenthOfAPixelWithNoise) {
  EXPECT_LT(centroid_errors(3.0, 1.0, 0.0, on_grey).max, 0.1);
  EXPECT_LT(centroid_errors(3.0, 1.0, 0.0, uneven_background).max, 0.1);
}

TEST(Outline, FindsTheCentreOfAPrintedMarkWithNoise) {
  EXPECT_LT(centroid_errors(3.0, 1.0, 0.2, on_grey).max, 0.1);
}

TEST(Outline, FindsTheCentreInDimAndBrightLight) {
  for (const double gain : {0.4, 0.7, 1.3}) EXPECT_LT(centroid_errors(3.0, gain, 0.1, on_grey).max, 0.1) << gain;
}

TEST(Outline, GivesASquaresMoments) {
  Square square{80.3, 60.2, 50.0, 0.0, kRed, 0.0};
  Picture picture = on_grey(square);
  picture.expose();
  State state;
  Input input;
  input.left = picture.view();
  const Output output = MarkDetector({red_mark()}, {}).step(input, state);
  const Shape& shape = output.marks.at(0).left.shape;
  EXPECT_NEAR(shape.area, 2500.0, 15.0);
  EXPECT_NEAR(shape.m_uu, 2500.0 / 12.0, 2.0);
  EXPECT_NEAR(shape.m_vv, 2500.0 / 12.0, 2.0);
  EXPECT_NEAR(shape.m_uv, 0.0, 1.0);
}

TEST(Outline, KeepsTheClassificationOfAMarkTooThinToTellItsColour) {
  Picture picture(60, 40, kGrey);
  picture.fill(10, 20, 40, 3, kRed);
  picture.expose();
  const std::vector<PixelRun> runs = {{20, 10, 50}, {21, 10, 50}, {22, 10, 50}};
  const OutlinedMark mark = outline(picture.view(), runs, {});
  EXPECT_EQ(mark.shape.area, 120.0);
  EXPECT_DOUBLE_EQ(mark.shape.v, 21.0);
}

}  // namespace
}  // namespace markservo::mark_detector
