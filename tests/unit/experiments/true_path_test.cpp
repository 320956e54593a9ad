#include "tests/experiments/localisation/true_path.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/unit/experiments/localisation_paths.hpp"

namespace markservo::experiments {
namespace {

TEST(TruePath, LiesBetweenItsSamples) {
  const PathPoint point = straight({1.0, 2.0}, M_PI / 2.0, 0.4, 2.0).at(0.5);
  EXPECT_NEAR(point.p_WR.x(), 1.0, 1e-12);
  EXPECT_NEAR(point.p_WR.y(), 2.2, 1e-12);
  EXPECT_NEAR(point.heading, M_PI / 2.0, 1e-12);
  EXPECT_NEAR(point.speed, 0.4, 1e-12);
}

TEST(TruePath, GoesStraightOnOutsideItsSamples) {
  const TruePath path = straight({0.0, 0.0}, 0.0, 0.4, 1.0);
  EXPECT_NEAR(path.at(-0.5).p_WR.x(), -0.2, 1e-12);
  EXPECT_NEAR(path.at(1.5).p_WR.x(), 0.6, 1e-12);
}

TEST(TruePath, TurnsThroughPiTheShortWay) {
  PathPoint before;
  before.heading = 3.1;
  PathPoint after;
  after.time = 1.0;
  after.heading = -3.1;
  EXPECT_NEAR(TruePath({before, after}).at(0.5).heading, M_PI, 1e-12);
}

TEST(TruePath, RefusesTimesThatDoNotRise) {
  EXPECT_THROW(TruePath({PathPoint{}, PathPoint{}}), std::invalid_argument);
  EXPECT_THROW(TruePath({PathPoint{}}), std::invalid_argument);
}

TEST(PathPoint, PlacesAPointOfTheRobot) {
  PathPoint point;
  point.p_WR = {1.0, 1.0};
  point.heading = M_PI / 2.0;
  const Eigen::Vector2d p_W = point.at({0.1, 0.2});
  EXPECT_NEAR(p_W.x(), 0.8, 1e-12);
  EXPECT_NEAR(p_W.y(), 1.1, 1e-12);
}

}  // namespace
}  // namespace markservo::experiments
