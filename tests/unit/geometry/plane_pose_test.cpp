#include "common/geometry/plane_pose.hpp"

#include <gtest/gtest.h>

namespace markservo::geometry {
namespace {

TEST(Wrapped, TurnsAnAngleByWholeTurnsToWithinHalfOne) {
  EXPECT_NEAR(wrapped(3.5), 3.5 - 2.0 * M_PI, 1e-12);
  EXPECT_NEAR(wrapped(-3.0 - 3.0), 2.0 * M_PI - 6.0, 1e-12);
  EXPECT_NEAR(wrapped(0.1 + 20.0 * M_PI), 0.1, 1e-12);
}

TEST(PlanePose, TakesAPointToTheFrameItIsToldIn) {
  const Eigen::Vector2d p_A = pose_from_degrees(1.0, 2.0, 90.0) * Eigen::Vector2d(0.3, 0.1);
  EXPECT_NEAR(p_A.x(), 0.9, 1e-12);
  EXPECT_NEAR(p_A.y(), 2.3, 1e-12);
}

TEST(PlanePose, TimesItsInverseIsNoMoveAtAll) {
  const PlanePose X_AB{0.4, -1.1, 2.5};
  const PlanePose X_AA = X_AB * X_AB.inverse();
  EXPECT_NEAR(X_AA.distance(), 0.0, 1e-12);
  EXPECT_NEAR(X_AA.heading, 0.0, 1e-12);
}

TEST(Chord, OfHalfACircleIsItsDiameter) {
  EXPECT_NEAR(chord(M_PI * 0.5, M_PI), 1.0, 1e-12);
  EXPECT_NEAR(chord(-M_PI * 0.5, M_PI), -1.0, 1e-12);
  EXPECT_DOUBLE_EQ(chord(0.7, 0.0), 0.7);
}

}  // namespace
}  // namespace markservo::geometry
