#include "services/mark-detector/learning/mark_share.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "services/mark-detector/picture/picture.hpp"
#include "tests/scenes/glossy_ball.hpp"

namespace markservo::mark_detector {
namespace {

// What the boxes' pixels are taken for, in px^2, against the truth.
struct Shares {
  double mark = 0.0;      // of the ball
  double mistaken = 0.0;  // of the wall, taken for the ball
  double all = 0.0;       // px of the ball in the box
};

Shares shares_of(const scenes::BallPicture& picture, const cv::Rect& box) {
  std::vector<LearningPixel> pixels =
      learning_pixels({{view_of(picture.image), box.x, box.y, box.width, box.height}}, true);
  set_mark_shares(pixels);
  Shares shares;
  for (int j = 0; j < box.height; ++j) {
    for (int i = 0; i < box.width; ++i) {
      const LearningPixel& pixel = pixels.at(static_cast<std::size_t>(j * box.width + i));
      const bool ball = picture.mask.at<std::uint8_t>(box.y + j, box.x + i) != 0;
      shares.all += ball ? 1.0 : 0.0;
      (ball ? shares.mark : shares.mistaken) += pixel.mark_share;
    }
  }
  return shares;
}

scenes::GlossyBall ball_before_a_wall() {
  scenes::GlossyBall ball;
  ball.body = bgr_of(215.0, 0.8, 190.0);
  ball.wall = bgr_of(200.0, 0.25, 180.0);
  ball.wall_slope = {0.2, -0.2};
  ball.to_lamp = {0.4, -0.4, std::sqrt(0.68)};
  ball.highlight_share = 0.05;
  return ball;
}

TEST(MarkShare, TellsABallAndItsHighlightFromTheWallInItsBoxsCorners) {
  const scenes::BallPicture picture = scenes::draw_ball(ball_before_a_wall(), 3);
  for (const cv::Point& shift : {cv::Point(0, 0), cv::Point(5, -5), cv::Point(-5, 3)}) {
    const Shares shares = shares_of(picture, picture.box + shift);
    // Along the outline, 3% of the ball, blur mixes both.
    EXPECT_GT(shares.mark, 0.9 * shares.all) << shift;
    EXPECT_LT(shares.mistaken, 0.05 * shares.all) << shift;
  }
}

TEST(MarkShare, GoesByPlaceAloneWhereABoxFillsThePicture) {
  scenes::GlossyBall ball = ball_before_a_wall();
  ball.width = ball.height = 60;
  ball.u = ball.v = 29.5;
  const scenes::BallPicture picture = scenes::draw_ball(ball, 3);
  std::vector<LearningPixel> pixels = learning_pixels({{view_of(picture.image), 0, 0, 60, 60}}, true);
  set_mark_shares(pixels);
  const MarkShareParameters parameters;
  EXPECT_NEAR(pixels.front().mark_share, parameters.share_at_edge, 0.01);
  EXPECT_NEAR(pixels.at(30 * 60 + 30).mark_share, parameters.share_in_middle, 0.03);
}

TEST(LearningPixels, AreTheBoxsAndThoseAroundItAsFarAsThePictureReaches) {
  const cv::Mat image(100, 200, CV_8UC3, cv::Scalar(10, 20, 30));
  const std::vector<LearningPixel> pixels = learning_pixels({{view_of(image), 0, 0, 40, 20}}, false);
  int inside = 0;
  for (const LearningPixel& pixel : pixels) inside += pixel.in_box ? 1 : 0;
  EXPECT_EQ(inside, 40 * 20);
  // A gap of 4 and 2 px, then 30 and 15 px, to the right and below.
  EXPECT_EQ(pixels.size(), 40U * 20U + 74U * 37U - 44U * 22U);
}

TEST(LearningPixels, StandForMorePixelsWhereTheBoxIsHuge) {
  const cv::Mat image(2000, 3000, CV_8UC3, cv::Scalar(10, 20, 30));
  const std::vector<LearningPixel> pixels = learning_pixels({{view_of(image), 500, 500, 2000, 1000}}, false);
  EXPECT_LE(pixels.size(), 210'000U);
  double area = 0.0;
  for (const LearningPixel& pixel : pixels) area += pixel.in_box ? pixel.area : 0.0;
  EXPECT_NEAR(area, 2000.0 * 1000.0, 0.02 * 2000.0 * 1000.0);
}

}  // namespace
}  // namespace markservo::mark_detector
