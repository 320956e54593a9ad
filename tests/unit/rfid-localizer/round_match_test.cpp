#include "services/rfid-localizer/round_match.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/unit/rfid-localizer/brute_force_round.hpp"

namespace markservo::rfid_localizer {
namespace {

using test::brute_force;
using test::Footprint;
using test::GaussianPlace;
using test::whole;

const ReadModel kModel(0.1, 0.01);
const std::vector<WindowPoint> kStanding = window_points(Eigen::Vector2d::Zero());

Eigen::Matrix2d round_prior(double sigma) {
  return sigma * sigma * Eigen::Matrix2d::Identity();
}

// The tags of a 10 cm lattice within `radius` (m) of `p`; those within 9 cm of `truth` were read.
std::vector<TagOutcome> round_at(const Eigen::Vector2d& truth, const Eigen::Vector2d& p, double radius) {
  std::vector<TagOutcome> outcomes;
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) {
      TagOutcome tag;
      tag.p_W = {0.1 * i, 0.1 * j};
      tag.reliability = 0.95;
      tag.read = (tag.p_W - truth).norm() < 0.09;
      if ((tag.p_W - p).norm() < radius) outcomes.push_back(tag);
    }
  }
  return outcomes;
}

// `share` of the standard deviation of the reference, at most, lies between the two.
void expect_same(const RoundMatch& match, const GaussianPlace& reference, double share) {
  const GaussianPlace found = whole(match);
  const double sigma = std::sqrt(reference.covariance.trace());
  EXPECT_LT((found.mean - reference.mean).norm(), share * sigma)
      << found.mean.transpose() << " against " << reference.mean.transpose() << " +- " << sigma;
  EXPECT_LT((found.covariance - reference.covariance).norm(), 2.0 * share * sigma * sigma)
      << found.covariance << "\nagainst\n"
      << reference.covariance;
}

TEST(RoundMatch, HasTheMomentsOfABruteForceGrid) {
  for (const double sigma : {0.005, 0.02, 0.05}) {
    const Eigen::Vector2d prior(0.012, -0.02);
    const auto outcomes = round_at({0.0, 0.03}, prior, 0.5);
    const auto match = match_round(prior, round_prior(sigma), outcomes, kStanding, kModel, {});
    const auto reference = brute_force(prior, round_prior(sigma), outcomes, kStanding, {}, 6.0 * sigma, 0.001);
    expect_same(match, reference, 0.03);
    EXPECT_NEAR(match.evidence, reference.evidence, 0.05 * reference.evidence) << sigma;
  }
}

TEST(RoundMatch, HasTheMomentsOfABruteForceGridForAThinSlantedPrior) {
  Eigen::Matrix2d prior;
  prior << 0.0025, 0.0024, 0.0024, 0.0025;
  const auto outcomes = round_at({0.03, 0.05}, {0.0, 0.0}, 0.6);
  const auto match = match_round({0.0, 0.0}, prior, outcomes, kStanding, kModel, {});
  expect_same(match, brute_force({0.0, 0.0}, prior, outcomes, kStanding, {}, 0.35, 0.001), 0.03);
}

TEST(RoundMatch, FindsTheRobotInAPriorMuchWiderThanTheFootprint) {
  for (const double sigma : {0.2, 0.4, 0.8}) {
    const Eigen::Vector2d truth(0.36, -0.28);
    const auto outcomes = round_at(truth, truth, 0.6);
    const auto match = match_round({0.0, 0.0}, round_prior(sigma), outcomes, kStanding, kModel, {});
    const auto reference = brute_force({0.0, 0.0}, round_prior(sigma), outcomes, kStanding, {}, 0.8, 0.005);
    expect_same(match, reference, 0.15);
    EXPECT_LT((whole(match).mean - truth).norm(), 0.04);
  }
}

TEST(RoundMatch, HasTheMomentsOfABruteForceGridWhileTheAntennaMoves) {
  const auto window = window_points({0.06, 0.04});
  const auto outcomes = round_at({0.02, 0.01}, {0.0, 0.0}, 0.6);
  const auto match = match_round({0.0, 0.0}, round_prior(0.03), outcomes, window, kModel, {});
  expect_same(match, brute_force({0.0, 0.0}, round_prior(0.03), outcomes, window, {}, 0.18, 0.001), 0.03);
}

TEST(RoundMatch, ThreePointsOfTheWayStandForAllOfIt) {
  const Eigen::Vector2d way(0.04, 0.0);  // of a round at 0.4 m/s
  std::vector<WindowPoint> all;
  constexpr int kPoints = 200;
  for (int i = 0; i < kPoints; ++i) all.push_back({((i + 0.5) / kPoints - 0.5) * way, 1.0 / kPoints});
  const auto outcomes = round_at({0.02, 0.01}, {0.0, 0.0}, 0.3);
  const auto three = brute_force({0.0, 0.0}, round_prior(0.03), outcomes, window_points(way), {}, 0.15, 0.004);
  const auto many = brute_force({0.0, 0.0}, round_prior(0.03), outcomes, all, {}, 0.15, 0.004);
  EXPECT_LT((three.mean - many.mean).norm(), 0.1 * std::sqrt(many.covariance.trace()));
  EXPECT_LT((three.covariance - many.covariance).norm(), 0.1 * many.covariance.trace());
}

TEST(WindowPoints, WeighOneAndLieEvenlyAroundTheMiddle) {
  for (const double way : {0.0, 0.001, 0.05, 1.0}) {
    double weight = 0.0;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double second = 0.0;
    for (const WindowPoint& point : window_points({0.6 * way, 0.8 * way})) {
      weight += point.weight;
      middle += point.weight * point.offset;
      second += point.weight * point.offset.squaredNorm();
    }
    EXPECT_NEAR(weight, 1.0, 1e-12);
    EXPECT_LT(middle.norm(), 1e-12);
    if (way > 0.01) {
      EXPECT_NEAR(second, way * way / 12.0, 1e-12) << "of an even motion";
    }
  }
}

TEST(RoundMatch, UsesTheMomentOfAReadWhereItIsKnown) {
  TagOutcome tag;
  tag.p_W = {0.1, 0.0};
  tag.read = tag.moment_known = true;
  tag.offset = {0.2, 0.0};
  const auto match = match_round({0.0, 0.0}, round_prior(0.05), {tag}, window_points({0.4, 0.0}), kModel, {});
  const auto reference = brute_force({0.0, 0.0}, round_prior(0.05), {tag}, window_points({0.4, 0.0}), {}, 0.3, 0.001);
  expect_same(match, reference, 0.03);
  EXPECT_LT(whole(match).mean.x(), -0.01) << "the antenna was 20 cm ahead when it read the tag";
}

TEST(RoundMatch, ASilenceTellsAsMuchAsARead) {
  TagOutcome tag;
  tag.p_W = {0.08, 0.0};
  tag.read = false;
  const auto match = match_round({0.0, 0.0}, round_prior(0.05), {tag}, kStanding, kModel, {});
  EXPECT_LT(whole(match).mean.x(), -0.01);
  expect_same(match, brute_force({0.0, 0.0}, round_prior(0.05), {tag}, kStanding, {}, 0.3, 0.001), 0.03);
}

TEST(RoundMatch, WithoutTagsNearLeavesThePriorAsItIs) {
  const auto match = match_round({1.0, 2.0}, round_prior(0.05), {}, kStanding, kModel, {});
  EXPECT_NEAR(match.evidence, 1.0, 1e-12);
  EXPECT_LT((whole(match).mean - Eigen::Vector2d(1.0, 2.0)).norm(), 1e-9);
  EXPECT_NEAR(whole(match).covariance.trace(), 2.0 * 0.0025, 0.02 * 0.005);
}

TEST(RoundMatch, SplitsWhatIsTooWideIntoPartsThatAddUpToTheWhole) {
  RoundMatchParameters in_one;
  in_one.widest = 1e9;
  RoundMatchParameters in_parts;
  in_parts.widest = 3.0;  // softnesses: 3 cm
  for (const double sigma : {0.05, 0.1}) {
    const auto outcomes = round_at({0.0, 0.0}, {2.5, 0.0}, 0.6);  // beyond the lattice's edge: hardly a tag
    const Eigen::Vector2d prior(2.5, 0.0);
    const auto parts = match_round(prior, round_prior(sigma), outcomes, kStanding, kModel, in_parts);
    const auto one = match_round(prior, round_prior(sigma), outcomes, kStanding, kModel, in_one);
    ASSERT_EQ(one.parts.size(), 1U);
    ASSERT_EQ(parts.parts.size(), sigma > 0.06 ? 3U : 2U);
    double share = 0.0;
    for (const PlacePart& part : parts.parts) {
      share += part.share;
      EXPECT_GT(part.covariance.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
      EXPECT_LT(part.covariance.trace(), one.parts[0].covariance.trace());
    }
    EXPECT_NEAR(share, 1.0, 1e-9);
    EXPECT_LT((whole(parts).mean - whole(one).mean).norm(), 1e-6);
    EXPECT_LT((whole(parts).covariance - whole(one).covariance).norm(), 1e-6);
  }
}

TEST(RoundMatch, TellsHowLikelyATagWasInside) {
  const auto outcomes = round_at({0.0, 0.0}, {0.0, 0.0}, 0.35);
  const auto match = match_round({0.0, 0.0}, round_prior(0.003), outcomes, kStanding, kModel, {});
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const double distance = outcomes[i].p_W.norm();
    if (distance < 0.05) {
      EXPECT_GT(match.inside[i], 0.98);
    }
    if (distance > 0.15) {
      EXPECT_LT(match.inside[i], 0.02);
    }
  }
}

TEST(RoundMatch, KeepsThePriorWhenNothingCanBeTrue) {
  RoundMatchParameters parameters;
  parameters.false_read = 0.0;
  TagOutcome far;
  far.p_W = {5.0, 0.0};
  far.read = true;
  const auto match = match_round({0.0, 0.0}, round_prior(0.01), {far}, kStanding, kModel, parameters);
  EXPECT_EQ(match.evidence, 0.0);
  ASSERT_EQ(match.parts.size(), 1U);
  EXPECT_EQ(match.parts[0].mean, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(match.parts[0].covariance, round_prior(0.01));
  EXPECT_EQ(match.inside.size(), 1U);
}

}  // namespace
}  // namespace markservo::rfid_localizer
