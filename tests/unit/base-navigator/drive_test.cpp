// Whole drives: the navigator before a simulated base with noise.

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/base-navigator/rig.hpp"

namespace markservo::base_navigator::test {
namespace {

using geometry::PlanePose;

constexpr double kForever = std::numeric_limits<double>::infinity();

TEST(Drive, DocksAMetreAheadAtTwelveCentimetres) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Rig rig(seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    rig.world.X_WR = {0.0, 0.15 * part(random), 0.2 * part(random)};
    rig.world.walls = {{{1.35, -0.5}, {1.35, 0.5}}};
    const PlanePose X_WG{1.0, 0.0, 0.0};
    rig.tell(Rig::goal_at(X_WG, 0.12));
    EXPECT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << "seed " << seed << ": " << rig.last.status.reason;
    EXPECT_LT(rig.distance_to(X_WG), 0.035) << seed;
    EXPECT_LT(rig.heading_error_to(X_WG), 5.0 * kDegree) << seed;
    EXPECT_GT(rig.nearest, 0.11) << seed;
    EXPECT_LE(rig.direction_changes, 8) << seed;
  }
}

TEST(Drive, ReachesTwentyGoalsInAHallWithinAMinuteEach) {
  double sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rig rig(seed);
    std::mt19937_64 random(77 * seed);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    const auto somewhere = [&] {
      return PlanePose{2.0 + 1.4 * part(random), 2.0 + 1.4 * part(random), M_PI * part(random)};
    };
    rig.world.walls = box(0.0, 0.0, 4.0, 4.0);
    rig.world.X_WR = somewhere();
    const PlanePose X_WG = somewhere();
    rig.tell(Rig::goal_at(X_WG));
    EXPECT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << "seed " << seed << ": " << rig.last.status.reason;
    EXPECT_LT(rig.distance_to(X_WG), 0.035) << seed;
    EXPECT_LT(rig.heading_error_to(X_WG), 6.0 * kDegree) << seed;
    EXPECT_LE(rig.direction_changes, 8) << seed;
    EXPECT_FALSE(rig.touched) << seed;
    EXPECT_LE(rig.fastest, 0.5 + 1e-9) << seed;
    EXPECT_LE(rig.fastest_turn, 1.0 + 1e-9) << seed;
    EXPECT_LE(rig.hardest, rig.robot.base->acceleration_max + 1e-6) << seed;
    EXPECT_LE(rig.hardest_turn, rig.robot.base->turn_acceleration_max + 1e-6) << seed;
    sum += rig.distance_to(X_WG);
  }
  EXPECT_LT(sum / 20.0, 0.015);
}

TEST(Drive, LimitsAboveTheBasesOwnAreCut) {
  NavigatorParameters parameters;
  parameters.motion.speed = 9.0;
  parameters.motion.turn_rate = 19.0;
  parameters.motion.acceleration = 9.0;
  Rig rig(1, parameters);
  rig.world.X_WR = {0.0, 0.0, 3.0};
  rig.tell(Rig::goal_at({5.0, 0.0, 0.0}));
  rig.run(6.0);
  EXPECT_GT(rig.fastest, 1.0);
  EXPECT_LE(rig.fastest, rig.robot.base->speed_max + 1e-9);
  EXPECT_LE(rig.fastest_turn, rig.robot.base->turn_rate_max + 1e-9);
  EXPECT_LE(rig.hardest, rig.robot.base->acceleration_max + 1e-6);
}

TEST(Drive, AGoalsSpeedIsKept) {
  Rig rig;
  Goal goal = Rig::goal_at({3.0, 0.0, 0.0});
  goal.speed = 0.2;
  rig.tell(goal);
  rig.run(8.0);
  EXPECT_NEAR(rig.fastest, 0.2, 0.005);
}

TEST(Drive, EntersADockFromTheSideAndLeavesItAgain) {
  Rig rig(5);
  rig.world.walls = box(0.0, 0.0, 4.0, 4.0);
  rig.world.X_WR = {3.0, 0.8, M_PI / 2.0};
  const PlanePose X_WD{4.0 - 0.22 - 0.125, 2.5, 0.0};
  rig.tell(Rig::goal_at(X_WD, 0.11));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << rig.last.status.reason;
  EXPECT_LT(rig.distance_to(X_WD), 0.035);
  EXPECT_GT(rig.nearest, 0.10);
  // Turning round needs more room than there is: it backs out first.
  const PlanePose X_WG{1.0, 1.0, M_PI};
  rig.tell(Rig::goal_at(X_WG, 0.0, 2));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << rig.last.status.reason;
  EXPECT_LT(rig.distance_to(X_WG), 0.035);
  EXPECT_FALSE(rig.touched);
}

TEST(Drive, BacksAwayFirstWhereItsCornersCannotPass) {
  Rig rig(8);
  rig.world.walls = {{{0.31, -1.0}, {0.31, 1.0}}};  // 9 cm before its front
  const PlanePose X_WG{-2.0, 0.0, M_PI};
  rig.tell(Rig::goal_at(X_WG));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 60.0), kForever) << rig.last.status.reason;
  EXPECT_LT(rig.distance_to(X_WG), 0.035);
  EXPECT_GT(rig.nearest, 0.04);
}

TEST(Drive, AllTheWayThatItGoesToMakeRoomIsCounted) {
  Rig rig(8);
  rig.world.walls = {{{0.31, -1.0}, {0.31, 1.0}}};
  rig.tell(Rig::goal_at({-2.0, 0.0, M_PI}));
  for (int i = 0; i < Rig::steps_in(10.0) && std::abs(rig.world.turn_rate) < 0.5; ++i) rig.step();
  ASSERT_GT(rig.world.X_WR.distance(), 0.02);
  EXPECT_NEAR(rig.state.manoeuvre.room.made(), rig.world.X_WR.distance(), 0.01);
}

TEST(Drive, ArrivesOnlyAfterItHasStoodForAWhile) {
  Rig rig(6);
  rig.world.position_sigma = 0.005;  // sharp from the beginning
  rig.tell(Rig::goal_at({0.5, 0.0, 0.0}));
  double stood = 0.0;
  for (int i = 0; i < 1500 && rig.step().status.state != DriveState::kArrived; ++i) {
    stood = rig.world.speed == 0.0 ? stood + 0.02 : 0.0;
  }
  EXPECT_EQ(rig.last.status.state, DriveState::kArrived);
  EXPECT_GE(stood, 0.7);
}

TEST(Drive, ASmallErrorBehindIsMadeUpByReversing) {
  Rig rig(2);
  const PlanePose X_WG{-0.2, 0.0, 0.0};
  rig.tell(Rig::goal_at(X_WG));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 20.0), kForever);
  EXPECT_LT(rig.distance_to(X_WG), 0.035);
  EXPECT_LT(rig.fastest_turn, 0.5);
}

TEST(Drive, AGoalRelativeToTheRobotIsTakenFromWhereItWasHeard) {
  Rig rig(3);
  rig.world.X_WR = {2.0, 1.0, M_PI / 2.0};
  rig.tell(Rig::goal_at({1.0, 2.0, M_PI}));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 30.0), kForever) << rig.last.status.reason;
  const PlanePose X_WG = rig.world.X_WR * PlanePose{0.8, 0.3, 0.4};
  Goal goal = Rig::goal_at({0.8, 0.3, 0.4}, 0.0, 2);
  goal.frame = GoalFrame::kRobot;
  rig.tell(goal);
  ASSERT_LT(rig.run_until(DriveState::kArrived, 30.0), kForever) << rig.last.status.reason;
  EXPECT_LT(rig.distance_to(X_WG), 0.06);
  EXPECT_LT(rig.heading_error_to(X_WG), 8.0 * kDegree);
}

TEST(Drive, AGoalRelativeToTheRobotIsDrivenOnceThoughAnotherWriterAlternatesWithIt) {
  Rig rig(3);
  rig.run(2.0);
  Goal relative = Rig::goal_at({0.3, 0.0, 0.0});
  relative.frame = GoalFrame::kRobot;
  relative.session = 6;
  Goal hold = Rig::goal_at({});
  hold.kind = GoalKind::kHold;
  hold.session = 7;
  for (int i = 0; i < 60; ++i) {
    rig.tell(hold);
    rig.run(0.1);
    rig.tell(relative);
    rig.run(0.4);
  }
  EXPECT_LT(rig.world.X_WR.distance(), 0.36);
}

TEST(Drive, AGoalRelativeToTheRobotFromBeforeTheStartIsNotDrivenOnceMore) {
  // Its first repetition, or the third when two were lost.
  for (const double heard_after : {0.02, 0.58}) {
    Rig rig;
    rig.run(heard_after);
    Goal goal = Rig::goal_at({0.8, 0.0, 0.0});
    goal.frame = GoalFrame::kRobot;
    rig.tell(goal);
    rig.run(3.0);
    EXPECT_EQ(rig.last.status.state, DriveState::kHold) << heard_after;
    EXPECT_NE(rig.last.status.reason.find("new goal_id"), std::string::npos) << rig.last.status.reason;
    EXPECT_EQ(rig.fastest, 0.0) << heard_after;
  }
}

TEST(Drive, ALongerGoalAgeLengthensTheGuardAfterTheStart) {
  NavigatorParameters parameters;
  parameters.trust.goal_age = 2.0;
  Rig rig(1, parameters);
  rig.run(1.5);
  Goal goal = Rig::goal_at({0.8, 0.0, 0.0});
  goal.frame = GoalFrame::kRobot;
  rig.tell(goal);
  rig.run(1.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kHold);
}

TEST(Drive, ANewGoalOnTheWayIsTakenOverSmoothly) {
  Rig rig(4);
  rig.tell(Rig::goal_at({3.0, 0.0, 0.0}));
  rig.run(3.0);
  EXPECT_GT(rig.world.speed, 0.4);
  const PlanePose X_WG{2.0, 1.5, M_PI / 2.0};
  rig.tell(Rig::goal_at(X_WG, 0.0, 2));
  const Output output = rig.step();
  EXPECT_EQ(output.status.goal_id, 2);
  ASSERT_LT(rig.run_until(DriveState::kArrived, 40.0), kForever);
  EXPECT_LT(rig.distance_to(X_WG), 0.035);
  EXPECT_LE(rig.hardest, rig.robot.base->acceleration_max + 1e-6);
}

TEST(Drive, HoldStandsStill) {
  Rig rig(4);
  rig.tell(Rig::goal_at({3.0, 0.0, 0.0}));
  rig.run(3.0);
  Goal hold = Rig::goal_at({}, 0.0, 2);
  hold.kind = GoalKind::kHold;
  rig.tell(hold);
  const Output output = rig.run(3.0);
  EXPECT_EQ(output.status.state, DriveState::kHold);
  EXPECT_EQ(output.status.reason, "");
  EXPECT_EQ(rig.world.speed, 0.0);
  EXPECT_LE(rig.hardest, 0.8 + 1e-6);
}

TEST(Drive, OnceArrivedItStaysUntilItIsMovedAway) {
  Rig rig(6);
  const PlanePose X_WG{0.5, 0.0, 0.0};
  rig.tell(Rig::goal_at(X_WG));
  ASSERT_LT(rig.run_until(DriveState::kArrived, 30.0), kForever);
  const double distance = rig.distance_to(X_WG);
  const int changes = rig.direction_changes;
  for (int i = 0; i < 1500; ++i) {
    const Output output = rig.step();
    ASSERT_EQ(output.status.state, DriveState::kArrived);
    ASSERT_EQ(output.command.speed, 0.0);
  }
  EXPECT_EQ(rig.distance_to(X_WG), distance);
  EXPECT_EQ(rig.direction_changes, changes);
  rig.world.X_WR.x -= 0.3;
  rig.run(1.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kDriving);
  EXPECT_LT(rig.run_until(DriveState::kArrived, 30.0), kForever);
}

TEST(Drive, GivesUpByNameWhenNoCorrectionHelps) {
  NavigatorParameters parameters;
  WorldSettings settings;
  settings.position_noise = 0.12;  // no tolerance can be met by such a pose
  Rig rig(1, parameters, settings);
  rig.tell(Rig::goal_at({0.5, 0.0, 0.0}));
  double time = 0.0;
  while (rig.last.status.reason.find("gave up") == std::string::npos && time < 200.0) {
    rig.run(1.0);
    time += 1.0;
    if (rig.last.status.state == DriveState::kArrived) break;
  }
  ASSERT_LT(time, 200.0);
  EXPECT_EQ(rig.last.status.state, DriveState::kHold) << rig.last.status.reason;
  EXPECT_LE(rig.direction_changes, 14);
  const int changes = rig.direction_changes;
  rig.run(20.0);
  EXPECT_EQ(rig.direction_changes, changes);
  EXPECT_EQ(rig.world.speed, 0.0);
}

}  // namespace
}  // namespace markservo::base_navigator::test
