#include "tests/experiments/localisation/gaussian_radius.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <random>
#include <stdexcept>

namespace markservo::experiments {
namespace {

TEST(MeanRadialError, IsSigmaTimesTheRootOfHalfPiOfARoundError) {
  const Eigen::Matrix2d covariance = 0.02 * 0.02 * Eigen::Matrix2d::Identity();
  EXPECT_NEAR(mean_radial_error(covariance), 0.02 * std::sqrt(M_PI / 2.0), 1e-12);
}

TEST(MeanRadialError, IsSigmaTimesTheRootOfTwoOverPiOfAnErrorAlongOneLine) {
  const Eigen::Vector2d along(0.6, 0.8);
  const Eigen::Matrix2d covariance = 0.03 * 0.03 * along * along.transpose();
  EXPECT_NEAR(mean_radial_error(covariance), 0.03 * std::sqrt(2.0 / M_PI), 1e-9);
}

TEST(MeanRadialError, IsWhatDrawingSaysOfAnEllipse) {
  Eigen::Matrix2d covariance;
  covariance << 4.0, 1.2, 1.2, 1.0;
  const Eigen::Matrix2d root = covariance.llt().matrixL();
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  constexpr int kDraws = 200'000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = normal(random);
    sum += (root * Eigen::Vector2d(u, normal(random))).norm();
  }
  EXPECT_NEAR(mean_radial_error(covariance), sum / kDraws, 0.01);
}

TEST(MeanRadialError, RefusesWhatIsNoCovariance) {
  EXPECT_THROW(mean_radial_error(-Eigen::Matrix2d::Identity()), std::invalid_argument);
  EXPECT_THROW(mean_radial_error(Eigen::Matrix2d::Constant(NAN)), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::experiments
