#include "services/rfid-localizer/wheel_prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace markservo::rfid_localizer {
namespace {

WheelNoise no_noise() {
  return {0.0, 0.0, 0.0, 0.0, 0.0, 0.32};
}

Hypothesis at(double x, double y, double heading, double scale = 0.0) {
  Hypothesis one;
  one.mean << x, y, heading, scale, 0.19;
  return one;
}

StateVector moved(const StateVector& state, const WheelMotion& motion) {
  Hypothesis one;
  one.mean = state;
  advance(one, motion, no_noise());
  return one.mean;
}

// Numeric derivative of the mean's own motion.
StateCovariance numeric_jacobian(const StateVector& state, const WheelMotion& motion) {
  StateCovariance F;
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 5; ++i) {
    const StateVector step = kStep * StateVector::Unit(i);
    F.col(i) = (moved(state + step, motion) - moved(state - step, motion)) / (2.0 * kStep);
  }
  return F;
}

TEST(WheelPrediction, GoesStraightByTheWayAndItsScale) {
  Hypothesis one = at(1.0, 2.0, M_PI / 6.0, 0.05);
  advance(one, {0.4, 0.0, 1.0, 0.0}, no_noise());
  EXPECT_NEAR(one.mean[kX], 1.0 + 0.42 * std::cos(M_PI / 6.0), 1e-12);
  EXPECT_NEAR(one.mean[kY], 2.0 + 0.21, 1e-12);
  EXPECT_NEAR(one.mean[kHeading], M_PI / 6.0, 1e-12);
}

TEST(WheelPrediction, CarriesTheCovarianceByTheJacobianOfTheMotion) {
  StateCovariance root = StateCovariance::Random();  // from a fixed seed of its own
  root.row(kDelay) *= 0.01;
  const StateCovariance P = root * root.transpose();
  for (const WheelMotion& motion :
       {WheelMotion{0.01, 0.0, 0.02, 0.0}, WheelMotion{0.2, 1.0, 0.5, 0.0}, WheelMotion{-0.1, -2.0, 0.5, 0.0}}) {
    Hypothesis one = at(0.3, -0.2, 2.0, 0.03);
    const StateCovariance F = numeric_jacobian(one.mean, motion);
    one.covariance = P;
    advance(one, motion, no_noise());
    EXPECT_LT((one.covariance - F * P * F.transpose()).norm(), 1e-7 * P.norm()) << motion.turn;
  }
}

// The noise as its parameters describe it, drawn 20,000 times along a bend.
TEST(WheelPrediction, HasTheCovarianceOfAMonteCarlo) {
  constexpr int kPieces = 40;
  constexpr int kDraws = 20'000;
  const WheelMotion piece{0.01, 0.02, 0.02, 0.0};
  const WheelNoise noise{0.06, 0.05, 0.01, 0.002, 0.003, 0.32};
  Hypothesis predicted = at(0.0, 0.0, 0.5);
  predicted.covariance.diagonal() << 1e-4, 4e-4, 0.03 * 0.03, 0.02 * 0.02, 0.005 * 0.005;
  const StateVector start_sigma = predicted.covariance.diagonal().cwiseSqrt();
  for (int i = 0; i < kPieces; ++i) advance(predicted, piece, noise);

  std::mt19937_64 bits(11);
  std::normal_distribution<double> normal;
  const double heading_sigma =
      std::sqrt(noise.drift * noise.drift * piece.way + noise.turn_error * noise.turn_error * piece.turn);
  const double way_sigma = 0.5 * noise.track * noise.drift * std::sqrt(piece.way);
  const double creep_sigma = noise.creep * std::sqrt(piece.time);
  Eigen::MatrixXd ends(5, kDraws);
  for (int draw = 0; draw < kDraws; ++draw) {
    StateVector x = at(0.0, 0.0, 0.5).mean;
    for (int i = 0; i < 5; ++i) x[i] += start_sigma[i] * normal(bits);
    for (int i = 0; i < kPieces; ++i) {
      const double way = piece.way * (1.0 + x[kScale]) + way_sigma * normal(bits);
      const double turn = piece.turn * (1.0 + x[kScale]);
      const double middle = x[kHeading] + 0.5 * turn;
      x[kX] += way * std::cos(middle) + creep_sigma * normal(bits);
      x[kY] += way * std::sin(middle) + creep_sigma * normal(bits);
      x[kHeading] += turn + heading_sigma * normal(bits);
      x[kScale] += noise.scale_walk * std::sqrt(piece.way) * normal(bits);
      x[kDelay] += noise.delay_walk * std::sqrt(piece.time) * normal(bits);
    }
    ends.col(draw) = x;
  }
  const StateVector mean = ends.rowwise().mean();
  const Eigen::MatrixXd centred = ends.colwise() - mean;
  const StateCovariance sampled = centred * centred.transpose() / (kDraws - 1);
  const StateVector sigma = sampled.diagonal().cwiseSqrt();
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(predicted.mean[i], mean[i], 0.05 * sigma[i]) << "place " << i;
    for (int j = 0; j < 5; ++j) {
      EXPECT_NEAR(predicted.covariance(i, j), sampled(i, j), 0.04 * sigma[i] * sigma[j]) << "places " << i << ", " << j;
    }
  }
}

TEST(WheelPrediction, APivotLetsThePlaceWander) {
  WheelNoise noise = no_noise();
  noise.pivot_wander = 0.02;
  Hypothesis one = at(0.0, 0.0, 0.3);
  advance(one, {0.0, -1.5, 1.0, 0.0, 1.5}, noise);
  EXPECT_NEAR(one.covariance(kX, kX), 0.02 * 0.02 * 1.5, 1e-12);
  EXPECT_NEAR(one.covariance(kY, kY), 0.02 * 0.02 * 1.5, 1e-12);
  EXPECT_EQ(one.covariance(kX, kY), 0.0);
  EXPECT_EQ(one.covariance(kHeading, kHeading), 0.0);
  Hypothesis straight = at(0.0, 0.0, 0.3);
  advance(straight, {0.4, 0.0, 1.0, 0.0, 0.0}, noise);
  EXPECT_EQ(straight.covariance(kX, kX), 0.0);
}

// Wheels that run against each other go half the track for each radian, wherever the robot's middle goes.
TEST(WheelPrediction, WheelsThatDriftMuchDriftInAPivotToo) {
  WheelNoise noise = no_noise();
  noise.turn_error = 0.03;
  noise.drift = 0.14;
  Hypothesis one = at(0.0, 0.0, 0.0);
  advance(one, {0.0, 1.5, 1.0, 0.0, 1.5}, noise);
  EXPECT_NEAR(one.covariance(kHeading, kHeading), 0.14 * 0.14 * 0.16 * 1.5, 1e-12);
  noise.drift = 0.045;
  one = at(0.0, 0.0, 0.0);
  advance(one, {0.0, 1.5, 1.0, 0.0, 1.5}, noise);
  EXPECT_NEAR(one.covariance(kHeading, kHeading), 0.03 * 0.03 * 1.5, 1e-12) << "others turn as well as track and tyres";
}

TEST(WheelPrediction, TheSharesAddUpToTheCovariance) {
  WheelNoise noise = no_noise();
  noise.drift = 0.1;
  noise.pivot_wander = 0.02;
  for (const WheelMotion& motion : {WheelMotion{0.3, 0.0, 1.0, 0.0, 0.0}, WheelMotion{0.0, 1.5, 1.0, 0.0, 1.5},
                                    WheelMotion{-0.2, 0.5, 1.0, 0.0, 0.5}}) {
    Hypothesis one = at(0.0, 0.0, 0.4, 0.02);
    const NoiseShares shares = noise_shares(one.mean, motion, noise);
    advance(one, motion, noise);
    const StateCovariance sum =
        noise.drift * noise.drift * shares.drift + noise.pivot_wander * noise.pivot_wander * shares.pivot_wander;
    EXPECT_LT((one.covariance - sum).norm(), 1e-15) << motion.turn;
  }
}

TEST(WheelPrediction, AnUnknownWayLeavesPlaceAndHeadingOpen) {
  Hypothesis one = at(0.0, 0.0, 0.0);
  advance(one, {0.0, 0.0, 0.5, 0.6}, no_noise());
  EXPECT_EQ(one.mean, at(0.0, 0.0, 0.0).mean);
  EXPECT_NEAR(one.covariance(kX, kX), 0.36, 1e-9);
  EXPECT_NEAR(one.covariance(kY, kY), 0.36, 1e-9);
  EXPECT_GT(one.covariance(kHeading, kHeading), 1.0);
}

TEST(WheelPrediction, AStandingRobotsCovarianceGrowsByCreepOnly) {
  Hypothesis one = at(0.0, 0.0, 0.0);
  advance(one, {0.0, 0.0, 9.0, 0.0}, {0.1, 0.1, 0.1, 0.0002, 0.0, 0.32});
  EXPECT_NEAR(std::sqrt(one.covariance(kX, kX)), 0.0006, 1e-9);
  EXPECT_EQ(one.covariance(kHeading, kHeading), 0.0);
}

// A record with a gap has long pieces: on a circle of radius 0.5 m each of them still ends on the circle.
TEST(WheelPrediction, StaysOnACircleHoweverLongThePieces) {
  for (const int pieces : {3, 10, 1000}) {
    Hypothesis one = at(0.0, 0.0, 0.0);
    const double turn = M_PI / pieces;
    for (int i = 0; i < pieces; ++i) advance(one, {0.5 * turn, turn, 0.02, 0.0}, no_noise());
    EXPECT_NEAR(one.mean[kX], 0.0, 1e-9) << pieces;
    EXPECT_NEAR(one.mean[kY], 1.0, 1e-9) << pieces;
    EXPECT_NEAR(one.mean[kHeading], M_PI, 1e-9) << pieces;
  }
}

}  // namespace
}  // namespace markservo::rfid_localizer
