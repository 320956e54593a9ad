#include "tests/scenes/plain_mark.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::scenes {
namespace {

constexpr geometry::StereoCamera kCamera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065};

// Facing the cameras, contrast 100, lens and pixel together blurring by 0.6 px.
PlainMark square_of(double width_px) {
  PlainMark mark;
  mark.size = 0.025;
  mark.p_C = point_at(kCamera, 400.3, 240.6, kCamera.fx * mark.size / width_px);
  mark.around = {60.0, 60.0, 60.0};
  mark.colour = {60.0, 60.0, 160.0};
  mark.blur_px = lens_blur(0.6);
  return mark;
}

// By hand: a view's two upright sides, w px long, tell a shift to sigma / contrast / sqrt(2 w e), e being the integral
// of the square of how the edge rises, per px. The disparity is the difference of two.
TEST(LeastError, OfAFacingSquareIsThatOfItsUprightSides) {
  for (const double width_px : {30.0, 60.0, 100.0}) {
    constexpr double kPerPx = 0.4681;
    const double by_hand = std::sqrt(2.0) * 3.0 / 100.0 / std::sqrt(2.0 * width_px * kPerPx);
    EXPECT_NEAR(least_disparity_sigma(square_of(width_px), kCamera, 3.0), by_hand, 0.03 * by_hand) << width_px;
  }
  EXPECT_NEAR(least_disparity_sigma(square_of(30.0), kCamera, 3.0), 0.0080, 0.0003);
  EXPECT_NEAR(least_disparity_sigma(square_of(60.0), kCamera, 3.0), 0.0056, 0.0002);
  EXPECT_NEAR(least_disparity_sigma(square_of(100.0), kCamera, 3.0), 0.0044, 0.0002);
}

TEST(LeastError, FallsWithContrastAndRisesWithNoise) {
  PlainMark strong = square_of(60.0);
  strong.colour = {60.0, 60.0, 210.0};
  const double plain = least_disparity_sigma(square_of(60.0), kCamera, 3.0);
  EXPECT_NEAR(least_disparity_sigma(strong, kCamera, 3.0), plain / 1.5, 1e-4);
  EXPECT_NEAR(least_disparity_sigma(square_of(60.0), kCamera, 6.0), 2.0 * plain, 1e-4);
}

TEST(PlainMark, OfABallIsAsWideAsTheConeOfSightThatTouchesIt) {
  PlainMark ball;
  ball.form = PlainForm::kBall;
  ball.size = 0.05;
  ball.p_C = {0.0, 0.2, 0.0};
  double widest = 0.0;
  for (const cv::Point2d& p : contour_of(ball, Eye(kCamera, false))) widest = std::max(widest, p.x - kCamera.cx_left);
  EXPECT_NEAR(widest, kCamera.fx * std::tan(std::asin(0.025 / 0.2)), 1e-3);
}

}  // namespace
}  // namespace markservo::scenes
