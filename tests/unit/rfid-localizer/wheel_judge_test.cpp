// Wheels whose true noise is drawn, a Kalman filter that is told another one, and what is judged of it.

#include "services/rfid-localizer/wheel_judge.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <utility>

#include "common/geometry/degrees.hpp"

namespace markservo::rfid_localizer {
namespace {

using geometry::degrees;

constexpr double kTrack = 0.32;
constexpr double kMargin = 1.3;
constexpr double kFix = 0.01;  // m, standard deviation of a place that is measured ten times a second

WheelNoise noise(double drift_deg, double pivot_wander) {
  WheelNoise result;
  result.drift = geometry::radians(drift_deg);
  result.pivot_wander = pivot_wander;
  result.track = kTrack;
  return result;
}

WheelNoise stated() {
  WheelNoise result = noise(2.0, 0.0);
  result.drift *= kMargin;
  return result;
}

// Legs of 3 m at 0.3 m/s and pivots of 90 degrees in a second between them.
class JudgedDrive {
 public:
  JudgedDrive(const WheelNoise& told, const WheelNoise& true_noise, unsigned seed)
      : truth_noise_(true_noise), bits_(seed), judge_(told, {}) {
    filter_.covariance.diagonal() << 1e-4, 1e-4, 1e-2, 1e-4, 2.5e-5;
  }

  void drive(int legs) {
    for (int leg = 0; leg < legs; ++leg) {
      for (int i = 0; i < 500; ++i) step({0.006, 0.0, 0.02, 0.0, 0.0});
      for (int i = 0; i < 50; ++i) step({0.0, M_PI / 100.0, 0.02, 0.0, M_PI / 100.0});
    }
  }
  // The robot is carried by so much, and told nothing.
  void carry(double dx) { truth_[kX] += dx; }

  WheelJudgement judgement() const { return judge_.judgement(); }
  const WheelJudge& judge() const { return judge_; }

 private:
  void step(const WheelMotion& piece) {
    Hypothesis moved;
    moved.mean = truth_;
    advance(moved, piece, noise(0.0, 0.0));
    truth_ = moved.mean;
    const NoiseShares shares = noise_shares(truth_, piece, truth_noise_);
    const StateCovariance added =
        std::pow(truth_noise_.drift, 2) * shares.drift + std::pow(truth_noise_.pivot_wander, 2) * shares.pivot_wander;
    const double heading = truth_[kHeading];
    truth_[kHeading] += std::sqrt(added(kHeading, kHeading)) * normal_(bits_);
    const double along = std::sqrt(std::pow(truth_noise_.drift, 2) * shares.drift.topLeftCorner<2, 2>().trace());
    const double aside = truth_noise_.pivot_wander * std::sqrt(piece.turning);
    const double step_along = along * normal_(bits_);
    truth_[kX] += step_along * std::cos(heading) + aside * normal_(bits_);
    truth_[kY] += step_along * std::sin(heading) + aside * normal_(bits_);

    judge_.moved(filter_.mean, piece);
    advance(filter_, piece, judge_.believed());
    if (++steps_ % 5 == 0) fix();
  }

  void fix() {
    Eigen::Matrix<double, 2, 5> H = Eigen::Matrix<double, 2, 5>::Zero();
    H.leftCols<2>().setIdentity();
    const Eigen::Vector2d measured = H * truth_ + kFix * Eigen::Vector2d(normal_(bits_), normal_(bits_));
    const Hypothesis before = filter_;
    const Eigen::Matrix2d C = H * before.covariance * H.transpose() + kFix * kFix * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 5, 2> K = before.covariance * H.transpose() * C.inverse();
    filter_.mean += K * (measured - H * before.mean);
    filter_.covariance -= K * C * K.transpose();
    filter_.covariance = 0.5 * (filter_.covariance + filter_.covariance.transpose()).eval();
    judge_.matched(before, filter_, H);
  }

  WheelNoise truth_noise_;
  std::mt19937_64 bits_;
  std::normal_distribution<double> normal_;
  WheelJudge judge_;
  StateVector truth_ = StateVector::Zero();
  Hypothesis filter_;
  int steps_ = 0;
};

TEST(WheelJudge, FindsTheNoiseOfWheelsThatAreWorseThanStated) {
  for (const auto& [drift_deg, pivot_wander] : {std::pair(8.0, 0.02), std::pair(5.0, 0.05), std::pair(15.0, 0.015)}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(fmt::format("{} deg, {} m, seed {}", drift_deg, pivot_wander, seed));
      JudgedDrive drive(stated(), noise(drift_deg, pivot_wander), seed);
      drive.drive(60);
      const WheelJudgement found = drive.judgement();
      EXPECT_TRUE(found.drift.too_small);
      EXPECT_TRUE(found.pivot_wander.too_small);
      EXPECT_NEAR(degrees(found.drift.stated), 2.0, 1e-9);
      EXPECT_NEAR(degrees(found.drift.fits), drift_deg, 0.25 * drift_deg);
      EXPECT_NEAR(found.pivot_wander.fits, pivot_wander, 0.25 * pivot_wander);
      EXPECT_NEAR(drive.judge().believed().drift, kMargin * found.drift.fits, 1e-12) << "as if robot.yaml said so";
      EXPECT_EQ(drive.judge().believed().pivot_wander, found.pivot_wander.fits);
    }
  }
}

// 60 pivots are 120 draws of the wander: it cannot be told better than to 6.5%.
TEST(WheelJudge, FindsTheNoiseAlmostAsWellAsItsDrawsAllow) {
  double drift_square = 0.0;
  double wander_square = 0.0;
  constexpr unsigned kSeeds = 20;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    JudgedDrive drive(stated(), noise(8.0, 0.02), seed);
    drive.drive(60);
    drift_square += std::pow(degrees(drive.judgement().drift.fits) / 8.0 - 1.0, 2) / kSeeds;
    wander_square += std::pow(drive.judgement().pivot_wander.fits / 0.02 - 1.0, 2) / kSeeds;
  }
  EXPECT_LT(std::sqrt(drift_square), 0.065);
  EXPECT_LT(std::sqrt(wander_square), 0.1);
}

TEST(WheelJudge, TakesOneErrorForNoProofTwice) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    JudgedDrive drive(stated(), noise(8.0, 0.02), seed);
    drive.drive(1);
    for (int leg = 2; leg <= 20; ++leg) {
      drive.drive(1);
      EXPECT_LT(degrees(drive.judgement().drift.fits), 2.0 * 8.0) << seed << ", leg " << leg;
      EXPECT_LT(drive.judgement().pivot_wander.fits, 2.0 * 0.02) << seed << ", leg " << leg;
    }
  }
}

TEST(WheelJudge, KnowsWithinTwoMinutes) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    JudgedDrive drive(stated(), noise(8.0, 0.02), seed);
    drive.drive(8);
    EXPECT_TRUE(drive.judgement().drift.too_small) << seed;
    EXPECT_TRUE(drive.judgement().pivot_wander.too_small) << seed;
    EXPECT_GT(degrees(drive.judgement().drift.fits), 5.0) << seed;
    EXPECT_GT(drive.judgement().pivot_wander.fits, 0.01) << seed;
  }
}

TEST(WheelJudge, TellsWhichOfTheNumbersIsWrong) {
  JudgedDrive drifting(stated(), noise(8.0, 0.0), 3);
  drifting.drive(30);
  EXPECT_TRUE(drifting.judgement().drift.too_small);
  EXPECT_FALSE(drifting.judgement().pivot_wander.too_small) << drifting.judgement().pivot_wander.fits;
  JudgedDrive wandering(stated(), noise(2.0, 0.02), 3);
  wandering.drive(30);
  EXPECT_FALSE(wandering.judgement().drift.too_small) << degrees(wandering.judgement().drift.fits);
  EXPECT_TRUE(wandering.judgement().pivot_wander.too_small);
}

TEST(WheelJudge, BelievesWheelsThatAreAsStated) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    JudgedDrive drive(stated(), noise(2.0, 0.0), seed);
    for (int part = 0; part < 6; ++part) {
      drive.drive(10);
      ASSERT_FALSE(drive.judgement().drift.too_small) << seed << ": " << degrees(drive.judgement().drift.fits);
      ASSERT_FALSE(drive.judgement().pivot_wander.too_small) << seed << ": " << drive.judgement().pivot_wander.fits;
    }
    EXPECT_EQ(drive.judge().believed().drift, stated().drift);
    EXPECT_EQ(drive.judge().believed().pivot_wander, 0.0);
  }
}

TEST(WheelJudge, IsContentWithWhatItProposed) {
  JudgedDrive first(stated(), noise(8.0, 0.02), 9);
  first.drive(60);
  WheelNoise mended = stated();
  mended.drift = kMargin * first.judgement().drift.fits;
  mended.pivot_wander = first.judgement().pivot_wander.fits;
  JudgedDrive second(mended, noise(8.0, 0.02), 10);
  second.drive(60);
  EXPECT_FALSE(second.judgement().drift.too_small);
  EXPECT_FALSE(second.judgement().pivot_wander.too_small);
}

TEST(WheelJudge, OnePushIsNoProofAgainstTheWheels) {
  JudgedDrive drive(stated(), noise(2.0, 0.0), 4);
  drive.drive(20);
  drive.carry(0.05);
  drive.drive(20);
  EXPECT_LT(degrees(drive.judgement().drift.fits), 4.0);
}

TEST(WheelJudge, KeepsWhatItFoundWhenTheEstimateBeginsAnew) {
  JudgedDrive drive(stated(), noise(8.0, 0.02), 5);
  drive.drive(20);
  WheelJudge judge = drive.judge();
  judge.restart();
  EXPECT_EQ(judge.judgement().drift.fits, drive.judgement().drift.fits);
  EXPECT_EQ(judge.believed().pivot_wander, drive.judge().believed().pivot_wander);
}

}  // namespace
}  // namespace markservo::rfid_localizer
