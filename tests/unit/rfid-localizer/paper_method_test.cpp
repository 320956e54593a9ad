#include "services/rfid-localizer/paper_method.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr std::int64_t kRound = 100'000;  // us
constexpr double kDegree = geometry::radians(1.0);

Eigen::Vector2d along(double angle, double way) {
  return way * Eigen::Vector2d(std::cos(angle), std::sin(angle));
}

double apart(double a, double b) {
  return std::abs(std::remainder(a - b, 2.0 * M_PI));
}

TEST(WeightedAverage, OfASymmetricSetIsItsMiddle) {
  const std::vector<Eigen::Vector2d> cross = {{0.3, 0.2}, {0.2, 0.3}, {0.3, 0.3}, {0.4, 0.3}, {0.3, 0.4}};
  EXPECT_LT((weighted_average(cross, 0.07) - Eigen::Vector2d(0.3, 0.3)).norm(), 1e-12);
  EXPECT_LT((weighted_average({{0.7, -0.1}}, 0.07) - Eigen::Vector2d(0.7, -0.1)).norm(), 1e-12);
}

// Weights by hand: the plain mean of 0, 0, 0 and 0.12 m is 0.03 m.
TEST(WeightedAverage, CountsATagAtTheEdgeLess) {
  const std::vector<Eigen::Vector2d> tags = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}, {0.12, 0.0}};
  const double inner = std::exp(-0.5 * std::pow(0.03 / 0.07, 2));
  const double outer = std::exp(-0.5 * std::pow(0.09 / 0.07, 2));
  const double average = weighted_average(tags, 0.07).x();
  EXPECT_NEAR(average, 0.12 * outer / (3.0 * inner + outer), 1e-12);
  EXPECT_LT(average, 0.03);
}

TEST(HoughDirection, IsThatOfAnExactLineWithinADegreeEitherWay) {
  for (int i = 0; i < 12; ++i) {
    const double angle = std::remainder((30.0 * i + 7.0) * kDegree, 2.0 * M_PI);
    std::deque<Eigen::Vector2d> points;
    for (int k = 0; k < 15; ++k) points.push_back(Eigen::Vector2d(0.5, -0.3) + along(angle, 0.04 * k));
    const auto direction = hough_direction(points, {});
    ASSERT_TRUE(direction) << angle;
    EXPECT_LT(apart(*direction, angle), 1.0 * kDegree) << angle / kDegree << " deg";
  }
}

TEST(HoughDirection, IsNotLedAstrayByOutliers) {
  for (int i = 0; i < 12; ++i) {
    const double angle = std::remainder(30.0 * i * kDegree, 2.0 * M_PI);
    std::deque<Eigen::Vector2d> points;
    for (int k = 0; k < 15; ++k) points.push_back(along(angle, 0.04 * k));
    for (const std::size_t outlier : {3U, 7U, 11U}) points[outlier] += along(angle + 0.5 * M_PI, 0.3);
    const auto direction = hough_direction(points, {});
    ASSERT_TRUE(direction) << angle;
    EXPECT_LT(apart(*direction, angle), 3.0 * kDegree) << angle / kDegree << " deg";
  }
}

TEST(HoughDirection, IsNoneOfTooFewPointsOrTooLittleWay) {
  const PaperParameters parameters;
  EXPECT_FALSE(hough_direction({}, parameters));
  EXPECT_FALSE(hough_direction({{0.0, 0.0}, {0.2, 0.0}}, parameters));
  EXPECT_TRUE(hough_direction({{0.0, 0.0}, {0.1, 0.0}, {0.2, 0.0}}, parameters));
  EXPECT_FALSE(hough_direction({{0.0, 0.0}, {0.02, 0.0}, {0.04, 0.0}}, parameters));
  EXPECT_FALSE(hough_direction({{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}}, parameters));
}

TEST(PaperMethod, MovesTheAverageOnBySpeedTimesDelayAlongTheDirection) {
  PaperMethod method{PaperParameters{}};
  std::optional<PaperEstimate> estimate;
  for (int k = 0; k < 10; ++k) estimate = method.observe(k * kRound, {along(2.0, 0.04 * k)}, 0.4);
  ASSERT_TRUE(estimate);
  EXPECT_EQ(estimate->utime, 9 * kRound);
  ASSERT_TRUE(estimate->direction);
  EXPECT_EQ(estimate->delay, 0.19);
  EXPECT_LT((estimate->measured - along(2.0, 0.36)).norm(), 1e-12);
  EXPECT_LT((estimate->compensated - estimate->measured - along(2.0, 0.4 * 0.19)).norm(), 0.4 * 0.19 * kDegree);
}

TEST(PaperMethod, WithoutASpeedTellsItFromItsOwnAverages) {
  PaperMethod method{PaperParameters{}};
  std::optional<PaperEstimate> estimate;
  for (int k = 0; k < 30; ++k) estimate = method.observe(k * kRound, {along(0.0, 0.04 * k)}, std::nullopt);
  EXPECT_NEAR(estimate->speed, 0.4, 1e-9);
}

TEST(PaperMethod, CompensatesNothingWhileTheDirectionIsNotKnown) {
  PaperMethod method{PaperParameters{}};
  const auto first = method.observe(0, {{0.3, 0.3}}, 0.4);
  ASSERT_TRUE(first);
  EXPECT_FALSE(first->direction);
  EXPECT_EQ(first->compensated, first->measured);
}

TEST(PaperMethod, SaysNothingOfARoundWithoutTags) {
  PaperMethod method{PaperParameters{}};
  EXPECT_FALSE(method.observe(0, {}, 0.4));
}

TEST(PaperMethod, FollowsABendByItsRecentAveragesOnly) {
  PaperMethod method{PaperParameters{}};
  std::optional<PaperEstimate> estimate;
  for (int k = 0; k < 40; ++k) estimate = method.observe(k * kRound, {along(0.0, 0.04 * k)}, 0.4);
  for (int k = 1; k <= 15; ++k) {
    estimate = method.observe((40 + k) * kRound, {along(0.0, 1.6) + along(0.5 * M_PI, 0.04 * k)}, 0.4);
  }
  EXPECT_LT(apart(*estimate->direction, 0.5 * M_PI), 1.0 * kDegree);
}

TEST(PaperMethod, BeginsAnewWhenRestarted) {
  PaperMethod method{PaperParameters{}};
  for (int k = 0; k < 10; ++k) method.observe(k * kRound, {along(0.0, 0.04 * k)}, 0.4);
  method.forget();
  EXPECT_FALSE(method.observe(0, {{0.4, 0.0}}, 0.4)->direction);
}

}  // namespace
}  // namespace markservo::rfid_localizer
