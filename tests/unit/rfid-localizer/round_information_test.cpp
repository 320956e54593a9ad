// What rounds of a standing robot are worth, against the Fisher information in closed form: a tag at distance rho that
// answers with the probability p(rho) of a logistic edge (radius r, softness s) tells (dp/drho)^2 / (p (1 - p)) =
// p (1 - p) / s^2 along rho. Summed over a lattice of spacing d that is pi r / (s d^2) per axis, so that one round is
// good for sigma = d sqrt(s / (pi r)), and K independent ones for sqrt(K) less.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "services/rfid-localizer/round_match.hpp"
#include "tests/unit/rfid-localizer/brute_force_round.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr double kRadius = 0.1;     // m
constexpr double kSoftness = 0.01;  // m
// Close enough together that one round already has a Gaussian's worth of outcomes at the edge.
constexpr double kSpacing = 0.02;  // m

struct Score {
  double rms = 0.0;      // m, per axis
  double claimed = 0.0;  // m, per axis, by the covariance
};

// `rounds` rounds after each other from a wide prior, at random places of the lattice.
Score score_of(int rounds, int trials) {
  const ReadModel model(kRadius, kSoftness);
  const test::Footprint footprint{kRadius, kSoftness, 0.0};
  std::mt19937_64 bits(2);
  std::uniform_real_distribution<double> uniform;
  double squares = 0.0;
  double variance = 0.0;
  for (int trial = 0; trial < trials; ++trial) {
    const Eigen::Vector2d truth = kSpacing * Eigen::Vector2d(uniform(bits), uniform(bits));
    PlacePart place;
    place.mean = truth + Eigen::Vector2d(0.01 * (uniform(bits) - 0.5), 0.01 * (uniform(bits) - 0.5));
    place.covariance = 0.02 * 0.02 * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d prior_information = place.covariance.inverse();
    for (int round = 0; round < rounds; ++round) {
      std::vector<TagOutcome> outcomes;
      for (int i = -10; i <= 10; ++i) {
        for (int j = -10; j <= 10; ++j) {
          TagOutcome tag;
          tag.p_W = kSpacing * Eigen::Vector2d(i, j);
          tag.read = uniform(bits) < footprint(truth, tag.p_W);
          outcomes.push_back(tag);
        }
      }
      const RoundMatch match =
          match_round(place.mean, place.covariance, outcomes, window_points({0.0, 0.0}), model, {});
      const auto all = test::whole(match);
      place.mean = all.mean;
      place.covariance = all.covariance;
    }
    squares += 0.5 * (place.mean - truth).squaredNorm() / trials;
    // What the rounds alone say, without the prior.
    const Eigen::Matrix2d information = place.covariance.inverse() - prior_information;
    variance += 0.5 * information.inverse().trace() / trials;
  }
  return {std::sqrt(squares), std::sqrt(variance)};
}

const double kOneRound = kSpacing * std::sqrt(kSoftness / (M_PI * kRadius));

TEST(RoundInformation, OfOneRoundIsTheClosedForm) {
  const Score score = score_of(1, 300);
  EXPECT_NEAR(score.claimed, kOneRound, 0.1 * kOneRound);
  EXPECT_NEAR(score.rms, kOneRound, 0.15 * kOneRound);
}

TEST(RoundInformation, OfNineRoundsIsThreeTimesAsGood) {
  const Score score = score_of(9, 60);
  EXPECT_NEAR(score.claimed, kOneRound / 3.0, 0.1 * kOneRound / 3.0);
  EXPECT_NEAR(score.rms, kOneRound / 3.0, 0.25 * kOneRound / 3.0);
}

}  // namespace
}  // namespace markservo::rfid_localizer
