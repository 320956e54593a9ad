// A turn on the spot without room: where the robot goes to have some, and how far.

#include "services/base-navigator/drive/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace markservo::base_navigator {
namespace {

constexpr double kClearance = 0.05;

class TurnWithoutRoom : public testing::Test {
 protected:
  // By something in that direction (rad).
  static GuardedTurn blocked_by(double bearing) {
    GuardedTurn turn;
    turn.passage.blocked = true;
    turn.free.limited = true;
    turn.free.bearing = bearing;
    return turn;
  }

  std::optional<Advice> step(double bearing, int corrections = 0) {
    return room_.step(parameters_, guard_, situation_, kClearance, blocked_by(bearing), corrections);
  }

  void go_to(double x, bool turning = true) {
    situation_.X_OR.x = x;
    room_.count(situation_, turning);
  }

  TurnParameters parameters_;
  PathGuard guard_{Outline{0.22, 0.18, 0.18}, MotionParameters(), PassageParameters()};
  Situation situation_;
  TurningRoom room_;
};

TEST_F(TurnWithoutRoom, GoesAwayFromWhatStandsInItsWay) {
  EXPECT_LT(step(0.3)->motion.speed, 0.0);
  EXPECT_GT(step(M_PI)->motion.speed, 0.0);
}

TEST_F(TurnWithoutRoom, StaysWhereThereIsNoRoomOnTheOtherSideEither) {
  SeenPoint behind;
  behind.p_R = {-0.24, 0.0};
  situation_.points = {behind};
  EXPECT_FALSE(step(0.3).has_value());
}

TEST_F(TurnWithoutRoom, GoesNoFartherThanAllowedAndAsFarAgainForEachCorrection) {
  step(0.3);
  go_to(-0.3);
  EXPECT_TRUE(step(0.3).has_value());
  go_to(-0.52);
  EXPECT_NEAR(room_.made(), 0.52, 1e-12);
  EXPECT_FALSE(step(0.3).has_value());
  EXPECT_TRUE(step(0.3, 1).has_value());
}

TEST_F(TurnWithoutRoom, OnlyTheWayOfTheTurnCounts) {
  step(0.3);
  go_to(-0.1);
  go_to(-0.2, false);
  go_to(-0.4);
  EXPECT_NEAR(room_.made(), 0.1, 1e-12);
}

TEST_F(TurnWithoutRoom, AnotherFrameOfTheWheelsIsNoWay) {
  step(0.3);
  situation_.epoch = 2;
  go_to(7.0);
  EXPECT_EQ(room_.made(), 0.0);
  go_to(7.1);
  EXPECT_NEAR(room_.made(), 0.1, 1e-12);
}

TEST_F(TurnWithoutRoom, WaitsWhileTheRobotRolls) {
  situation_.measured.speed = 0.1;
  PassageState passage;
  const GuardedTurn turn = turn_on_spot(guard_, situation_, kClearance, M_PI / 2.0, passage);
  EXPECT_FALSE(turn.passage.blocked);
  EXPECT_EQ(turn.passage.motion.turn_rate, 0.0);
  situation_.measured.speed = 0.0;
  EXPECT_GT(turn_on_spot(guard_, situation_, kClearance, M_PI / 2.0, passage).passage.motion.turn_rate, 0.5);
}

}  // namespace
}  // namespace markservo::base_navigator
