#include "tests/scenes/area_coverage.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::scenes {
namespace {

constexpr double kHardlyAny_px = 1e-3;

double total(const cv::Mat1f& coverage) {
  return cv::sum(coverage)[0];
}

TEST(AreaCoverage, IsTheShareOfEachPixelThatARectangleCovers) {
  // From 10.25 to 12.5 along the columns, from 5.1 to 6.9 along the rows, pixels reaching half a pixel either way.
  const cv::Mat1f coverage =
      blurred_coverage({{10.25, 5.1}, {12.5, 5.1}, {12.5, 6.9}, {10.25, 6.9}}, {8, 3, 8, 8}, kHardlyAny_px);
  EXPECT_NEAR(coverage(2, 2), 0.25 * 0.4, 1e-5);
  EXPECT_NEAR(coverage(3, 3), 1.0 * 1.0, 1e-5);
  EXPECT_NEAR(coverage(4, 4), 1.0 * 0.4, 1e-5);
  EXPECT_NEAR(coverage(3, 5), 0.0, 1e-5);
  EXPECT_NEAR(total(coverage), 2.25 * 1.8, 1e-4);
}

TEST(AreaCoverage, IsTheSameWhicheverWayThePolygonTurns) {
  const std::vector<cv::Point2d> one{{3.1, 2.2}, {14.7, 4.9}, {7.3, 15.8}};
  const std::vector<cv::Point2d> other(one.rbegin(), one.rend());
  const cv::Rect pixels(0, 0, 20, 20);
  EXPECT_LT(cv::norm(blurred_coverage(one, pixels, 0.7), blurred_coverage(other, pixels, 0.7), cv::NORM_INF), 1e-5);
}

TEST(AreaCoverage, KeepsAreaAndMiddleUnderBlur) {
  const std::vector<cv::Point2d> triangle{{8.1, 8.2}, {24.7, 10.9}, {13.3, 27.8}};
  const cv::Mat1f coverage = blurred_coverage(triangle, {0, 0, 40, 40}, 0.9);
  const double area = 0.5 * std::abs((24.7 - 8.1) * (27.8 - 8.2) - (13.3 - 8.1) * (10.9 - 8.2));
  EXPECT_NEAR(total(coverage), area, 1e-3 * area);
  cv::Point2d middle;
  for (int y = 0; y < coverage.rows; ++y) {
    for (int x = 0; x < coverage.cols; ++x) middle += cv::Point2d(x, y) * static_cast<double>(coverage(y, x)) / area;
  }
  EXPECT_NEAR(middle.x, (8.1 + 24.7 + 13.3) / 3.0, 2e-3);
  EXPECT_NEAR(middle.y, (8.2 + 10.9 + 27.8) / 3.0, 2e-3);
}

TEST(AreaCoverage, OfAStraightEdgeRisesAsTheBlurSays) {
  // The edge lies at column 9.7: what a pixel at 9 shows of a blur of 0.8 px, averaged over its square.
  const cv::Mat1f coverage = blurred_coverage({{9.7, -40}, {60, -40}, {60, 60}, {9.7, 60}}, {0, 0, 20, 20}, 0.8);
  double expected = 0.0;
  constexpr int kSteps = 1000;
  for (int k = 0; k < kSteps; ++k) {
    const double at = 9.0 - 0.5 + (k + 0.5) / kSteps;
    expected += 0.5 * std::erfc((9.7 - at) / (0.8 * M_SQRT2)) / kSteps;
  }
  EXPECT_NEAR(coverage(10, 9), expected, 1e-3);
}

}  // namespace
}  // namespace markservo::scenes
