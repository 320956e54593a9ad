// Creeping until the heading is known: when it begins, ends and fails.

#include "services/base-navigator/drive/exploration.hpp"

#include <gtest/gtest.h>

namespace markservo::base_navigator {
namespace {

class UnknownHeading : public testing::Test {
 protected:
  UnknownHeading() { situation_.heading_sigma = 1.8; }

  // With the robot `x` m from where the wheels' frame begins.
  std::optional<Advice> step(double x) {
    situation_.X_OR.x = x;
    return exploration_.step(parameters_, 0.3, guard_, situation_, 0.15);
  }

  ExploreParameters parameters_;
  PathGuard guard_{Outline{0.22, 0.18, 0.18}, MotionParameters(), PassageParameters()};
  Situation situation_;
  Exploration exploration_;
};

TEST_F(UnknownHeading, OnceBegunItIsToBecomeKnownBetterThanADriveNeeds) {
  EXPECT_EQ(step(0.0)->motion.speed, parameters_.speed);
  situation_.heading_sigma = 0.25;
  EXPECT_TRUE(step(0.1).has_value());
  situation_.heading_sigma = 0.14;
  EXPECT_FALSE(step(0.2).has_value());
  situation_.heading_sigma = 0.25;
  EXPECT_FALSE(step(0.2).has_value());
}

TEST_F(UnknownHeading, FailsAfterItsDistanceUntilTheHeadingIsKnownAllTheSame) {
  step(0.0);
  EXPECT_EQ(step(0.41)->state, DriveState::kLost);
  EXPECT_TRUE(exploration_.failed());
  situation_.heading_sigma = 0.1;
  EXPECT_FALSE(step(0.41).has_value());
  EXPECT_FALSE(exploration_.failed());
}

TEST_F(UnknownHeading, AnotherGoalPermitsToTryOnceMore) {
  step(0.0);
  step(0.41);
  exploration_.forget_failure();
  EXPECT_FALSE(exploration_.failed());
  EXPECT_EQ(step(0.41)->state, DriveState::kDriving);
}

TEST_F(UnknownHeading, APauseOrAnotherFrameOfTheWheelsBeginsItsDistanceAnew) {
  step(0.0);
  exploration_.interrupt();
  EXPECT_EQ(step(0.39)->state, DriveState::kDriving);
  EXPECT_EQ(step(0.60)->state, DriveState::kDriving);
  situation_.epoch = 2;
  EXPECT_EQ(step(7.0)->state, DriveState::kDriving);
}

}  // namespace
}  // namespace markservo::base_navigator
