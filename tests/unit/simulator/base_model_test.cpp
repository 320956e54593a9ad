#include "services/simulator/base/base_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace markservo::simulator {
namespace {

constexpr double kStep_s = 0.002;

robot::BaseDescription test_base() {
  return *robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml").base;
}

BaseModelParameters ideal() {
  BaseModelParameters parameters;
  parameters.scale_sigma = 0.0;
  parameters.drift = 0.0;
  return parameters;
}

BaseModel ideal_base(const geometry::PlanePose& start = {}) {
  return {test_base(), ideal(), start, 1};
}

void wait(BaseModel& base, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kStep_s));
  for (int i = 0; i < steps; ++i) base.step(kStep_s);
}

double spread(const std::vector<double>& values) {
  double squares = 0.0;
  for (const double value : values) squares += value * value;
  return std::sqrt(squares / static_cast<double>(values.size()));
}

TEST(BaseModel, DrivesStraightAheadAlongItsHeading) {
  BaseModel base = ideal_base({1.0, 2.0, 0.6});
  base.command(0.4, 0.0);
  wait(base, 2.0);
  const double way = 0.4 * 2.0 - 0.5 * 0.4 * 0.4 / test_base().acceleration_max;
  EXPECT_NEAR(base.pose().x, 1.0 + way * std::cos(0.6), 1e-9);
  EXPECT_NEAR(base.pose().y, 2.0 + way * std::sin(0.6), 1e-9);
  EXPECT_EQ(base.pose().heading, 0.6);
  EXPECT_NEAR(base.speed(), 0.4, 1e-12);
}

TEST(BaseModel, AConstantTurnClosesTheCircle) {
  BaseModel base = ideal_base();
  base.command(0.3, 1.0);
  wait(base, 1.0);  // up to speed
  const geometry::PlanePose begin = base.pose();
  double turned = 0.0;
  double farthest = 0.0;
  while (turned < 2.0 * M_PI - 0.5 * kStep_s) {
    base.step(kStep_s);
    turned = base.pose().heading - begin.heading;
    farthest = std::max(farthest, std::hypot(base.pose().x - begin.x, base.pose().y - begin.y));
  }
  EXPECT_NEAR(farthest, 2.0 * 0.3 / 1.0, 1e-5) << "the circle's diameter";
  EXPECT_LT(std::hypot(base.pose().x - begin.x, base.pose().y - begin.y), 0.3 * kStep_s);
}

TEST(BaseModel, OneLongStepEndsWhereManyShortOnesDo) {
  BaseModel base = ideal_base();
  base.command(0.3, 1.0);
  wait(base, 1.0);  // up to speed
  const geometry::PlanePose begin = base.pose();
  base.step(1.5);
  const Eigen::Vector2d middle = begin * Eigen::Vector2d(0.0, 0.3 / 1.0);
  const Eigen::Vector2d arm = Eigen::Vector2d(base.pose().x, base.pose().y) - middle;
  EXPECT_NEAR(arm.norm(), 0.3, 1e-9) << "it stays on its circle";
  EXPECT_NEAR(base.pose().heading - begin.heading, 1.5, 1e-9);
  EXPECT_NEAR(arm.dot(Eigen::Vector2d(std::sin(base.pose().heading), -std::cos(base.pose().heading))), 0.3, 1e-9);
}

TEST(BaseModel, TurnsOnTheSpotWithTheWheelsGoingOppositeWays) {
  BaseModel base = ideal_base();
  base.command(0.0, 1.0);
  wait(base, 3.0);
  EXPECT_NEAR(std::hypot(base.pose().x, base.pose().y), 0.0, 1e-12);
  const double rim = 0.5 * test_base().track * base.pose().heading;
  EXPECT_NEAR(base.right_distance(), rim, 2.0 * test_base().metres_per_tick());
  EXPECT_NEAR(base.left_distance(), -rim, 2.0 * test_base().metres_per_tick());
}

TEST(BaseModel, TheTicksTellTheHeadingOfAnIdealBase) {
  BaseModel base = ideal_base();
  base.command(0.4, -0.7);
  wait(base, 2.0);
  const double told = (base.right_distance() - base.left_distance()) / test_base().track;
  EXPECT_NEAR(told, base.pose().heading, 2.0 * test_base().metres_per_tick() / test_base().track);
}

TEST(BaseModel, NeverExceedsItsLimits) {
  const robot::BaseDescription limits = test_base();
  BaseModel base = ideal_base();
  double speed = 0.0;
  double turn_rate = 0.0;
  for (int i = 0; i < 3200; ++i) {
    if (i == 0) base.command(100.0, 100.0);
    if (i == 1500) base.command(-100.0, -100.0);
    base.step(kStep_s);
    // Speeds are averages over a step: two neighbours differ by one step's acceleration.
    EXPECT_LE(std::abs(base.speed() - speed), limits.acceleration_max * kStep_s * (1.0 + 1e-6)) << "step " << i;
    EXPECT_LE(std::abs(base.turn_rate() - turn_rate), limits.turn_acceleration_max * kStep_s * (1.0 + 1e-6));
    speed = base.speed();
    turn_rate = base.turn_rate();
    EXPECT_LE(std::abs(speed), limits.speed_max * (1.0 + 1e-9));
    EXPECT_LE(std::abs(turn_rate), limits.turn_rate_max * (1.0 + 1e-9));
  }
  EXPECT_NEAR(speed, -limits.speed_max, 1e-9);
  EXPECT_NEAR(turn_rate, -limits.turn_rate_max, 1e-9);
}

TEST(BaseModel, FreezingBrakesInTheShortestWay) {
  BaseModel base = ideal_base();
  base.command(0.4, 0.0);
  wait(base, 1.0);
  const double x = base.pose().x;
  base.freeze();
  wait(base, 2.0);
  EXPECT_NEAR(base.pose().x - x, 0.4 * 0.4 / (2.0 * test_base().acceleration_max), 1e-9);
  EXPECT_EQ(base.speed(), 0.0);
}

TEST(BaseModel, TheCountersWrapAroundAndTheDistancesDoNot) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BaseModel base(test_base(), ideal(), {}, seed);
    const WheelTicks first = base.ticks();
    base.command(0.4, 0.0);
    wait(base, 2.0);
    EXPECT_LT(base.ticks().left, first.left) << "seed " << seed;
    EXPECT_GE(base.ticks().left, 0);
    const std::int32_t range = 1 << test_base().counter_bits;
    const std::int32_t counted = (base.ticks().left - first.left + range) % range;
    EXPECT_NEAR(counted * test_base().metres_per_tick(), base.left_distance(), 1e-12);
    EXPECT_GT(base.left_distance(), 0.5);
  }
}

TEST(BaseModel, FullWidthCountersWrapIntoNegativeNumbers) {
  robot::BaseDescription wide = test_base();
  wide.counter_bits = 32;
  BaseModel base(wide, ideal(), {}, 1);
  EXPECT_LT(base.ticks().left, 0) << "2^32 - n is -n as an int32";
  EXPECT_GT(base.ticks().left, -3000);
  base.command(0.4, 0.0);
  wait(base, 2.0);
  EXPECT_GT(base.ticks().left, 0);
}

TEST(BaseModel, OneFactorScalesTheTrueWayOfBothWheels) {
  BaseModelParameters parameters = ideal();
  parameters.scale_sigma = 0.02;
  std::vector<double> errors;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    BaseModel base(test_base(), parameters, {}, seed);
    base.command(0.5, 0.0);
    wait(base, 1.0);
    errors.push_back(base.pose().x / base.left_distance() - 1.0);
    EXPECT_EQ(base.pose().heading, 0.0);
  }
  EXPECT_NEAR(spread(errors), 0.02, 0.02 * 0.15) << "four standard errors";
}

TEST(BaseModel, TheHeadingDriftsWithTheRootOfTheWay) {
  BaseModelParameters parameters = ideal();
  parameters.drift = 0.035;
  for (const double seconds : {2.0, 8.0}) {
    std::vector<double> drifts;
    double way = 0.0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      BaseModel base(test_base(), parameters, {}, seed);
      base.command(0.5, 0.0);
      wait(base, seconds);
      drifts.push_back(base.pose().heading);
      way = base.left_distance();
    }
    EXPECT_NEAR(spread(drifts), 0.035 * std::sqrt(way), 0.15 * 0.035 * std::sqrt(way)) << way << " m";
  }
}

TEST(BaseModel, ThePlaceWandersWithTheRootOfTheTurning) {
  BaseModelParameters parameters = ideal();
  parameters.pivot_wander = 0.02;
  for (const double seconds : {2.0, 6.0}) {
    std::vector<double> x, y;
    double turned = 0.0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
      BaseModel base(test_base(), parameters, {}, seed);
      base.command(0.0, -1.5);
      wait(base, seconds);
      x.push_back(base.pose().x);
      y.push_back(base.pose().y);
      turned = base.turned();
      EXPECT_NEAR(base.pose().heading, -turned, 1e-9) << "the wheels tell the turn truly";
    }
    const double expected = 0.02 * std::sqrt(turned);
    EXPECT_NEAR(spread(x), expected, 0.15 * expected) << seconds << " s";
    EXPECT_NEAR(spread(y), expected, 0.15 * expected) << seconds << " s";
  }
}

TEST(BaseModel, TheWanderOfAPivotDoesNotDependOnTheStep) {
  BaseModelParameters parameters = ideal();
  parameters.pivot_wander = 0.02;
  std::vector<double> x;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    BaseModel base(test_base(), parameters, {}, seed);
    base.command(0.0, 1.5);
    for (int i = 0; i < 200; ++i) base.step(0.01);
    x.push_back(base.pose().x / std::sqrt(base.turned()));
  }
  EXPECT_NEAR(spread(x), 0.02, 0.15 * 0.02);
}

TEST(BaseModel, DrivingStraightNothingWanders) {
  BaseModelParameters parameters = ideal();
  parameters.pivot_wander = 0.1;
  BaseModel base(test_base(), parameters, {}, 3);
  base.command(0.5, 0.0);
  wait(base, 4.0);
  EXPECT_EQ(base.pose().y, 0.0);
  EXPECT_EQ(base.turned(), 0.0);
}

// A world of before is the same world: its other noise comes from streams of its own.
TEST(BaseModel, WanderChangesNoOtherNoise) {
  BaseModelParameters parameters;
  parameters.slip = 0.05;
  BaseModelParameters wandering = parameters;
  wandering.pivot_wander = 0.02;
  BaseModel plain(test_base(), parameters, {}, 11);
  BaseModel other(test_base(), wandering, {}, 11);
  for (BaseModel* base : {&plain, &other}) {
    base->command(0.3, 0.8);
    wait(*base, 5.0);
  }
  EXPECT_EQ(plain.pose().heading, other.pose().heading);
  EXPECT_EQ(plain.ticks().left, other.ticks().left);
  EXPECT_EQ(plain.wheel_travel(), other.wheel_travel());
  EXPECT_NE(plain.pose().x, other.pose().x);
}

TEST(BaseModel, TellsHowFarItsWheelsWentWhileItPivoted) {
  BaseModel base = ideal_base();
  base.command(0.0, 1.0);
  wait(base, 3.0);
  EXPECT_NEAR(base.wheel_travel(), 0.5 * test_base().track * base.turned(), 1e-9);
  EXPECT_NEAR(base.turned(), base.pose().heading, 1e-9);
}

TEST(BaseModel, StandingStillNothingDrifts) {
  BaseModel base(test_base(), {0.02, 0.5, 0.2, 0.1}, {0.1, 0.2, 0.3}, 4);
  wait(base, 10.0);
  EXPECT_EQ(base.pose().x, 0.1);
  EXPECT_EQ(base.pose().heading, 0.3);
}

TEST(BaseModel, SlippingWheelsMakeLessWayThanTheyTell) {
  BaseModelParameters parameters = ideal();
  parameters.slip = 0.1;
  BaseModel base(test_base(), parameters, {}, 7);
  base.command(1.0, 0.0);
  wait(base, 60.0);
  const double told = 0.5 * (base.left_distance() + base.right_distance());
  double way = 0.0;  // along the path: slip turns it too
  BaseModel again(test_base(), parameters, {}, 7);
  again.command(1.0, 0.0);
  for (int i = 0; i < 30'000; ++i) {
    again.step(kStep_s);
    way += again.speed() * kStep_s;
  }
  EXPECT_NEAR(1.0 - way / told, 0.1, 0.01);
  EXPECT_NE(base.pose().heading, 0.0) << "each wheel slips for itself";
}

TEST(BaseModel, TheSameSeedDrivesTheSameWay) {
  const auto run = [](std::uint64_t seed) {
    BaseModel base(test_base(), {0.02, 0.035, 0.05}, {}, seed);
    base.command(0.5, 0.3);
    wait(base, 3.0);
    return base.pose();
  };
  EXPECT_EQ(run(3).x, run(3).x);
  EXPECT_EQ(run(3).heading, run(3).heading);
  EXPECT_NE(run(3).heading, run(4).heading);
}

TEST(BaseModel, RefusesWhatIsNoNumberOrOutOfRange) {
  BaseModel base = ideal_base();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(base.command(nan, 0.0), std::invalid_argument);
  EXPECT_THROW(base.command(0.0, nan), std::invalid_argument);
  EXPECT_THROW(base.step(0.0), std::invalid_argument);
  EXPECT_THROW(BaseModel(test_base(), {-0.1, 0.0, 0.0}, {}, 1), std::invalid_argument);
  EXPECT_THROW(BaseModel(test_base(), {0.0, 0.0, 0.6}, {}, 1), std::invalid_argument);
  EXPECT_THROW(BaseModel(test_base(), ideal(), {nan, 0.0, 0.0}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::simulator
