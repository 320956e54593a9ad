#include "services/rfid-localizer/free_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace markservo::rfid_localizer {
namespace {

const Eigen::Vector2d kAtR = Eigen::Vector2d::Zero();

// All three ways to move with one mean, `first` of them likely.
Mixture moving(const FreeMotionModel& model, const Eigen::Vector2d& velocity, std::size_t likely) {
  Mixture mixture = model.start({{1.0, 2.0}, 1e-4 * Eigen::Matrix2d::Identity()}, {0.19, 0.005});
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    mixture[i].weight = i == likely ? 0.998 : 0.001;
    if (i == 0) continue;
    mixture[i].mean.segment<2>(kVelocityX) = velocity;
    mixture[i].covariance(kVelocityX, kVelocityX) = mixture[i].covariance(kVelocityY, kVelocityY) = 1e-4;
  }
  return mixture;
}

double sum_of_weights(const Mixture& mixture) {
  double sum = 0.0;
  for (const Hypothesis& one : mixture) sum += one.weight;
  return sum;
}

FreeMotionParameters without_switching() {
  FreeMotionParameters parameters;
  parameters.setting_off = parameters.settling = 1e-12;
  return parameters;
}

TEST(FreeMotion, CruisesWithItsVelocity) {
  const FreeMotionModel model(kAtR, without_switching());
  Mixture mixture = moving(model, {0.3, -0.4}, 1);
  for (int i = 0; i < 10; ++i) model.predict(mixture, i * 100'000, (i + 1) * 100'000);
  EXPECT_NEAR(mixture[1].mean[kX], 1.3, 1e-6);
  EXPECT_NEAR(mixture[1].mean[kY], 1.6, 1e-6);
  // White acceleration of strength q over t: q t^3 / 3 of the place, q t of the velocity, whatever the steps.
  const double q = std::pow(FreeMotionParameters().cruise, 2);
  EXPECT_NEAR(mixture[1].covariance(kX, kX), 1e-4 + 1e-4 + q / 3.0, 1e-9);
  EXPECT_NEAR(mixture[1].covariance(kVelocityX, kVelocityX), 1e-4 + q, 1e-9);
}

TEST(FreeMotion, AStandingRobotKeepsItsPlace) {
  const FreeMotionModel model(kAtR, without_switching());
  Mixture mixture = moving(model, {0.3, -0.4}, 0);
  for (int i = 0; i < 100; ++i) model.predict(mixture, i * 100'000, (i + 1) * 100'000);
  EXPECT_NEAR(mixture[0].mean[kX], 1.0, 1e-9);
  EXPECT_NEAR(mixture[0].mean[kY], 2.0, 1e-9);
  EXPECT_LT(std::sqrt(mixture[0].covariance(kX, kX)), 0.015) << "10 s at 1 mm/s";
}

TEST(FreeMotion, ARobotThatComesToAStandHasNoVelocityLeft) {
  const FreeMotionModel model(kAtR, {});
  Mixture mixture = moving(model, {0.3, -0.4}, 2);
  for (int i = 0; i < 5; ++i) model.predict(mixture, i * 100'000, (i + 1) * 100'000);
  EXPECT_GT(mixture[0].weight, 0.1);
  EXPECT_EQ(mixture[0].mean.segment<2>(kVelocityX), Eigen::Vector2d(0.0, 0.0));
  EXPECT_LT(mixture[0].covariance(kVelocityX, kVelocityX), 1e-5);
}

TEST(FreeMotion, SwitchesBetweenItsWaysToMoveWithoutLosingProbability) {
  const FreeMotionModel model(kAtR, {});
  for (const std::size_t likely : {0U, 1U, 2U}) {
    for (const std::int64_t time : {1, 100'000, 10'000'000}) {
      Mixture mixture = moving(model, {0.3, 0.0}, likely);
      model.predict(mixture, 0, time);
      EXPECT_NEAR(sum_of_weights(mixture), 1.0, 1e-9);
      for (const Hypothesis& one : mixture) EXPECT_GT(one.weight, 0.0);
    }
  }
}

TEST(FreeMotion, ManoeuvringSettlesIntoStandingAndCruisingAlike) {
  const FreeMotionModel model(kAtR, {});
  Mixture mixture = moving(model, {0.3, 0.0}, 2);
  model.predict(mixture, 0, 200'000);
  EXPECT_GT(mixture[0].weight, 0.1);
  EXPECT_NEAR(mixture[0].weight, mixture[1].weight, 0.01);
}

TEST(FreeMotion, PredictsThePartsMomentsTogetherAsItPredictsNoneApart) {
  const FreeMotionModel model(kAtR, {});
  Mixture mixture = moving(model, {0.3, 0.0}, 1);
  Hypothesis twin = mixture[1];
  mixture[1].weight *= 0.5;
  twin.weight *= 0.5;
  mixture[1].mean[kX] -= 0.01;
  twin.mean[kX] += 0.01;
  mixture.push_back(twin);
  const Hypothesis before = moments(mixture, -1);
  model.clean(mixture);
  ASSERT_EQ(mixture.size(), 3U);
  for (int mode = 0; mode < 3; ++mode) EXPECT_EQ(mixture[static_cast<std::size_t>(mode)].mode, mode);
  const Hypothesis after = moments(mixture, -1);
  EXPECT_LT((after.mean - before.mean).norm(), 1e-9);
  EXPECT_LT((after.covariance - before.covariance).norm(), 1e-9);
}

TEST(FreeMotion, AWayToMoveThatHasNotBeenLatelyCanComeBack) {
  const FreeMotionModel model(kAtR, {});
  Mixture mixture = moving(model, {0.3, 0.0}, 1);
  mixture[0].weight = 1e-200;
  model.clean(mixture);
  EXPECT_GE(mixture[0].weight, 1e-4);
}

TEST(FreeMotion, TellsTheHeadingOfARobotThatMovesForward) {
  const FreeMotionModel model(kAtR, {});
  Mixture mixture = moving(model, {-0.3, 0.3}, 1);
  for (Hypothesis& one : mixture) one.mean.segment<2>(kVelocityX) = Eigen::Vector2d(-0.3, 0.3);
  const PoseEstimate estimate = model.pose(mixture, 0);
  EXPECT_NEAR(estimate.pose[2], 0.75 * M_PI, 1e-9);
  EXPECT_NEAR(estimate.speed, 0.3 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(std::sqrt(estimate.covariance(2, 2)), 0.01 / estimate.speed, 0.2 * 0.01 / estimate.speed);
}

TEST(FreeMotion, GivesThePoseOfRWhereverTheAntennaIs) {
  const FreeMotionModel model({0.1, 0.05}, {});
  Mixture mixture = moving(model, {0.0, 0.4}, 1);
  for (Hypothesis& one : mixture) one.mean.segment<2>(kVelocityX) = Eigen::Vector2d(0.0, 0.4);
  const PoseEstimate estimate = model.pose(mixture, 0);
  EXPECT_NEAR(estimate.pose[0], 1.0 + 0.05, 1e-9);
  EXPECT_NEAR(estimate.pose[1], 2.0 - 0.1, 1e-9);
}

TEST(FreeMotion, DoesNotKnowTheHeadingOfARobotThatStands) {
  const FreeMotionModel model({0.1, 0.0}, {});
  for (const double speed : {0.0, 1e-13, 1e-9, 1e-3}) {
    Mixture mixture = model.start({{1.0, 2.0}, 1e-4 * Eigen::Matrix2d::Identity()}, {0.19, 0.005});
    for (Hypothesis& one : mixture) one.mean[kVelocityX] = speed;
    const PoseEstimate estimate = model.pose(mixture, 0);
    EXPECT_GT(std::sqrt(estimate.covariance(2, 2)), 1.5) << speed << " m/s";
    EXPECT_GT(std::sqrt(estimate.covariance(0, 0) + estimate.covariance(1, 1)), 0.1)
        << "where R is about the antenna is open as well, at " << speed << " m/s";
    EXPECT_GT(estimate.covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0) << speed;
  }
}

}  // namespace
}  // namespace markservo::rfid_localizer
