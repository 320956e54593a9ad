#include "services/rfid-localizer/hypothesis.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

namespace markservo::rfid_localizer {
namespace {

Hypothesis gaussian(double weight, double x, double heading, double variance = 1e-4) {
  Hypothesis one;
  one.weight = weight;
  one.mean[kX] = x;
  one.mean[kHeading] = heading;
  one.covariance = variance * StateCovariance::Identity();
  return one;
}

TEST(Moments, OfTwoGaussiansAreThoseByHand) {
  Hypothesis a = gaussian(1.0, 0.0, 0.0, 0.01);
  Hypothesis b = gaussian(3.0, 2.0, 0.0, 0.04);
  a.mean[kY] = 4.0;
  b.mean[kY] = 0.0;
  const Hypothesis both = moments({a, b}, kHeading);
  EXPECT_NEAR(both.weight, 4.0, 1e-12);
  EXPECT_NEAR(both.mean[kX], 1.5, 1e-12);
  EXPECT_NEAR(both.mean[kY], 1.0, 1e-12);
  // Inner variance 0.25 * 0.01 + 0.75 * 0.04, and between them 0.25 * 1.5^2 + 0.75 * 0.5^2.
  EXPECT_NEAR(both.covariance(kX, kX), 0.0325 + 0.75, 1e-12);
  EXPECT_NEAR(both.covariance(kX, kY), 0.25 * (-1.5 * 3.0) + 0.75 * (0.5 * -1.0), 1e-12);
  EXPECT_NEAR(both.covariance(kHeading, kHeading), 0.0325, 1e-12);
}

TEST(Moments, OfAnglesAtEitherSideOfTheSeamLieAtTheSeam) {
  const Hypothesis both = moments({gaussian(1.0, 0.0, 3.1), gaussian(1.0, 0.0, -3.1)}, kHeading);
  EXPECT_NEAR(std::abs(both.mean[kHeading]), M_PI, 1e-9);
  EXPECT_NEAR(both.covariance(kHeading, kHeading), 1e-4 + std::pow(M_PI - 3.1, 2), 1e-9);
}

TEST(Moments, OfHeadingsAreTurnedBackIntoOneTurn) {
  const Hypothesis both =
      moments({gaussian(1.0, 0.0, 3.0 + 4.0 * M_PI), gaussian(1.0, 0.0, 3.2 - 2.0 * M_PI)}, kHeading);
  EXPECT_NEAR(both.mean[kHeading], 3.1, 1e-9);
  EXPECT_NEAR(both.covariance(kHeading, kHeading), 1e-4 + 0.01, 1e-9);
}

TEST(Moments, OfAllHeadingsAlikeAreThoseOfAFlatCircle) {
  Mixture mixture;
  for (int i = 0; i < 16; ++i) mixture.push_back(gaussian(1.0 / 16.0, 0.0, i * M_PI / 8.0));
  EXPECT_NEAR(moments(mixture, kHeading).covariance(kHeading, kHeading), M_PI * M_PI / 3.0, 0.05);
}

TEST(Moments, WithoutAnAngleTakeNumbersAsTheyAre) {
  EXPECT_NEAR(moments({gaussian(1.0, 0.0, 3.1), gaussian(1.0, 0.0, -3.1)}, -1).mean[kHeading], 0.0, 1e-12);
}

TEST(Tidy, MergesNeighboursAndKeepsTheFirstTwoMoments) {
  Mixture mixture = {gaussian(0.2, 0.000, 3.14), gaussian(0.5, 0.004, -3.14), gaussian(0.3, 5.0, 0.0)};
  mixture[0].covariance(kX, kHeading) = mixture[0].covariance(kHeading, kX) = 5e-5;
  const Hypothesis before = moments(mixture, kHeading);
  tidy(mixture, 1e-4, 0.7, 100, kHeading);
  ASSERT_EQ(mixture.size(), 2U) << "across the seam";
  const Hypothesis after = moments(mixture, kHeading);
  EXPECT_LT((after.mean - before.mean).norm(), 1e-9);
  EXPECT_LT((after.covariance - before.covariance).norm(), 1e-9);
}

TEST(Tidy, KeepsApartWhatIsFarInOnePlaceOnly) {
  Mixture mixture = {gaussian(0.5, 0.0, 0.0), gaussian(0.5, 0.0, 0.02)};  // two standard deviations of heading
  tidy(mixture, 1e-4, 0.7, 100, kHeading);
  EXPECT_EQ(mixture.size(), 2U);
}

// A wide Gaussian would swallow a narrow one that says much more.
TEST(Tidy, MeasuresDistanceByTheNarrowerOfTwo) {
  Mixture mixture = {gaussian(0.5, 0.0, 0.0, 1.0), gaussian(0.5, 0.05, 0.0, 1e-4)};
  tidy(mixture, 1e-4, 0.7, 100, kHeading);
  EXPECT_EQ(mixture.size(), 2U);
}

TEST(Tidy, DropsTheLightOnesAndBringsTheWeightsToOne) {
  Mixture mixture = {gaussian(3e-9, 0.0, 0.0), gaussian(8e-6, 1.0, 0.0), gaussian(2e-6, 2.0, 0.0)};
  tidy(mixture, 0.01, 0.7, 100, kHeading);
  ASSERT_EQ(mixture.size(), 2U);
  EXPECT_NEAR(mixture[0].weight, 0.8, 1e-3);
  EXPECT_NEAR(mixture[0].weight + mixture[1].weight, 1.0, 1e-12);
}

TEST(Tidy, LeavesOneHowEverLight) {
  Mixture mixture = {gaussian(1e-300, 1.0, 0.0), gaussian(2e-300, 2.0, 0.0)};
  tidy(mixture, 1.0, 0.7, 100, kHeading);
  ASSERT_EQ(mixture.size(), 1U);
  EXPECT_EQ(mixture[0].mean[kX], 2.0);
  EXPECT_NEAR(mixture[0].weight, 1.0, 1e-12);
}

TEST(Tidy, HoldsTooManyMoreCoarselyAndClaimsToKnowNoMore) {
  Mixture mixture(50);
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    mixture[i].mean[kX] = 0.1 * static_cast<double>(i);
    mixture[i].covariance = 1e-4 * StateCovariance::Identity();
  }
  tidy(mixture, 1e-6, 0.7, 50, kHeading);
  ASSERT_EQ(mixture.size(), 50u);
  const Hypothesis before = moments(mixture, kHeading);
  tidy(mixture, 1e-6, 0.7, 8, kHeading);
  EXPECT_LE(mixture.size(), 8u);
  const Hypothesis after = moments(mixture, kHeading);
  EXPECT_NEAR(after.mean[kX], before.mean[kX], 1e-9);
  EXPECT_NEAR(after.covariance(kX, kX), before.covariance(kX, kX), 1e-9);
}

}  // namespace
}  // namespace markservo::rfid_localizer
