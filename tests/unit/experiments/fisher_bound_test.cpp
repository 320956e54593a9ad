#include "tests/experiments/localisation/fisher_bound.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <stdexcept>

#include "tests/unit/experiments/localisation_paths.hpp"

namespace markservo::experiments {
namespace {

constexpr double kRound = 0.1;   // s
constexpr double kDelay = 0.19;  // s

BoundInput rounds_from(double first_middle, int count) {
  BoundInput input;
  input.reader.tags = lattice(0.10, 2.0);
  for (int i = 0; i < count; ++i) {
    const double middle = first_middle + kRound * i;
    input.rounds.push_back({middle, middle + kDelay});
  }
  input.prior.position_variance = {0.1, 0.1};
  input.prior.heading_variance = M_PI * M_PI / 3.0;
  input.prior.delay_variance = 0.005 * 0.005;
  return input;
}

EncoderNoise perfect_encoders() {
  EncoderNoise noise;
  noise.scale_sigma = 0.0;
  noise.heading_drift = 0.0;
  return noise;
}

double trace_after(const BoundInput& from, double time, const TruePath& path, const EncoderNoise& noise) {
  BoundInput input = from;
  input.times = {time};
  return live_bound(input, path, noise).front().topLeftCorner<2, 2>().trace();
}

TEST(FisherBound, FallsWithTheRootOfTheRoundsWhileTheBaseStands) {
  BoundInput input = rounds_from(1.0, 16);
  input.prior.position_variance = {1e6, 1e6};
  input.times = {1.0 + kDelay, 1.0 + kDelay + 15.0 * kRound + 1e-9};
  const auto bound = live_bound(input, standing({0.03, 0.02}), EncoderNoise{});
  EXPECT_NEAR(std::sqrt(bound[0](0, 0) / bound[1](0, 0)), 4.0, 1e-3);
  const double one =
      1.0 / read_information(input.reader, standing({0.03, 0.02}), 1.0).topLeftCorner<2, 2>().inverse()(0, 0);
  EXPECT_NEAR(1.0 / bound[0](0, 0), one, 1e-3 * one);
}

TEST(FisherBound, CountsARoundFromItsArrivalOnly) {
  const TruePath path = standing({0.03, 0.02});
  const BoundInput input = rounds_from(1.0, 2);
  const double second = input.rounds[1].arrival;
  EXPECT_EQ(trace_after(input, second - 1e-6, path, EncoderNoise{}), trace_after(input, 1.0 + kDelay, path, {}));
  EXPECT_LT(trace_after(input, second, path, EncoderNoise{}), 0.6 * trace_after(input, 1.0 + kDelay, path, {}));
}

TEST(FisherBound, GrowsWithTheWayOnUnknownScale) {
  const TruePath path = straight({-1.0, 0.0}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 1);
  input.prior.heading_variance = 0.0;
  input.prior.delay_variance = 0.0;
  input.prior.position_variance = {0.0, 0.0};
  EncoderNoise noise = perfect_encoders();
  noise.scale_sigma = 0.02;
  input.times = {1.0};
  const Eigen::Matrix4d bound = live_bound(input, path, noise).front();
  EXPECT_NEAR(std::sqrt(bound(0, 0)), 0.02 * 0.4, 1e-9);
  EXPECT_NEAR(bound(1, 1), 0.0, 1e-12);
}

TEST(FisherBound, GrowsAcrossTheWayWithTheHeadingsDrift) {
  const TruePath path = straight({-1.0, 0.0}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 1);
  input.prior = BoundPrior{};
  EncoderNoise noise = perfect_encoders();
  noise.heading_drift = 0.03;
  input.times = {5.0};
  const Eigen::Matrix4d bound = live_bound(input, path, noise).front();
  const double way = 0.4 * 5.0;
  EXPECT_NEAR(bound(2, 2), 0.03 * 0.03 * way, 1e-9);
  EXPECT_NEAR(bound(1, 1), 0.03 * 0.03 * way * way * way / 3.0, 0.01 * bound(1, 1));
}

TEST(FisherBound, GrowsWithTheWheelsOwnWayInAPivot) {
  std::vector<PathPoint> points;
  for (int i = 0; i <= 100; ++i) {
    PathPoint point;
    point.time = 0.02 * i;
    point.heading = point.turned = 0.015 * i;
    point.wheel_travel = 1.0 + 0.16 * point.turned;
    points.push_back(point);
  }
  BoundInput input = rounds_from(0.0, 1);
  input.prior = BoundPrior{};
  input.times = {2.0};
  EncoderNoise noise = perfect_encoders();
  noise.heading_drift = 0.14;
  noise.pivot_wander = 0.02;
  const Eigen::Matrix4d bound = live_bound(input, TruePath(points), noise).front();
  EXPECT_NEAR(bound(2, 2), 0.14 * 0.14 * 0.16 * 1.5, 1e-9);
  EXPECT_NEAR(bound(0, 0), 0.02 * 0.02 * 1.5, 1e-9);
  EXPECT_NEAR(bound(1, 1), 0.02 * 0.02 * 1.5, 1e-9);
}

TEST(FisherBound, CannotTellADelayAtConstantSpeed) {
  const TruePath path = straight({-1.0, 0.02}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 20);
  input.prior.heading_variance = 0.0;
  input.prior.delay_variance = 0.010 * 0.010;
  const double arrived = input.rounds.back().arrival;
  BoundInput known = input;
  known.prior.delay_variance = 0.0;
  const double unknown_delay = trace_after(input, arrived, path, perfect_encoders());
  const double known_delay = trace_after(known, arrived, path, perfect_encoders());
  EXPECT_NEAR(unknown_delay - known_delay, std::pow(0.010 * 0.4, 2), 0.05 * std::pow(0.010 * 0.4, 2));
}

TEST(FisherBound, LearnsTheHeadingFromTheWay) {
  const TruePath path = straight({-1.0, 0.02}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 40);
  input.times = {input.rounds.front().arrival, input.rounds.back().arrival};
  const auto bound = live_bound(input, path, EncoderNoise{});
  EXPECT_GT(bound[0](2, 2), 1.0);
  EXPECT_LT(std::sqrt(bound[1](2, 2)), 0.05);
}

TEST(FisherBound, IsWorseWithoutEncoders) {
  const TruePath path = straight({-1.0, 0.02}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 40);
  input.times = {input.rounds.back().arrival};
  const double with = live_bound(input, path, EncoderNoise{}).front().topLeftCorner<2, 2>().trace();
  const double without = live_bound(input, path, FreeMotion{}).front().topLeftCorner<2, 2>().trace();
  EXPECT_GT(without, 1.5 * with);
}

TEST(FisherBound, GrowsWithTheSpeedThatNobodyMeasures) {
  const TruePath path = straight({-1.0, 0.0}, 0.0, 0.4, 10.0);
  BoundInput input = rounds_from(0.0, 1);
  input.reader.tags = {{50.0, 50.0}};
  input.prior = BoundPrior{};
  FreeMotion motion;
  motion.speed_sigma = 0.1;
  motion.acceleration = 0.0;
  input.times = {2.0};
  EXPECT_NEAR(live_bound(input, path, motion).front()(0, 0), 0.01 * 4.0, 1e-9);
  motion.speed_sigma = 0.0;
  motion.acceleration = 0.3;
  EXPECT_NEAR(live_bound(input, path, motion).front()(0, 0), 0.09 * 8.0 / 3.0, 1e-9);
}

TEST(FisherBound, TakesTheHeadingFromTheVelocityWithoutEncoders) {
  BoundInput input = rounds_from(0.0, 1);
  input.reader.tags = {{50.0, 50.0}};
  FreeMotion motion;
  motion.speed_sigma = 0.04;
  motion.acceleration = 0.0;
  input.times = {1.0};
  const TruePath moving = straight({-1.0, 0.0}, 0.5, 0.4, 10.0);
  EXPECT_NEAR(std::sqrt(live_bound(input, moving, motion).front()(2, 2)), 0.1, 1e-9);
  EXPECT_TRUE(std::isinf(live_bound(input, standing({0.0, 0.0}), motion).front()(2, 2)));
}

TEST(FisherBound, RefusesTimesBeforeTheFirstRound) {
  BoundInput input = rounds_from(1.0, 2);
  input.times = {1.0};
  EXPECT_THROW(live_bound(input, standing({0.0, 0.0}), EncoderNoise{}), std::invalid_argument);
  input.rounds.clear();
  EXPECT_THROW(live_bound(input, standing({0.0, 0.0}), EncoderNoise{}), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::experiments
