#include "tests/experiments/localisation/live_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/unit/experiments/localisation_paths.hpp"

namespace markservo::experiments {
namespace {

constexpr double kNeverSettled = 1e9;  // s

// A true pose, off by `off` (m).
PoseEstimate estimate_at(const TruePath& path, double time, const Eigen::Vector2d& off = Eigen::Vector2d::Zero()) {
  const PathPoint truth = path.at(time);
  PoseEstimate estimate;
  estimate.time = time;
  estimate.p_WR = truth.p_WR + off;
  estimate.heading = truth.heading;
  estimate.speed = truth.speed;
  estimate.localised = true;
  return estimate;
}

TEST(LiveScore, IsTheDistanceToTheTruth) {
  const TruePath path = straight({0.0, 0.0}, 0.0, 0.4, 10.0);
  const LiveScore score =
      score_live({estimate_at(path, 0.0, {0.03, 0.04}), estimate_at(path, 1.0)}, path, {0.0, 1.0}, kNeverSettled);
  ASSERT_EQ(score.all.size(), 2U);
  EXPECT_NEAR(score.all[0], 0.05, 1e-12);
  EXPECT_NEAR(score.all[1], 0.0, 1e-12);
  EXPECT_TRUE(score.settled.empty());
}

TEST(LiveScore, MovesThePoseOnAtItsOwnSpeedAndTurnRate) {
  const TruePath path = straight({0.0, 0.0}, 0.0, 0.4, 10.0);
  PoseEstimate slow = estimate_at(path, 1.0);
  slow.speed = 0.3;
  EXPECT_NEAR(score_live({slow}, path, {1.2}, kNeverSettled).all[0], 0.2 * 0.1, 1e-12);
  PoseEstimate turning = estimate_at(path, 1.0);
  turning.turn_rate = 0.5;
  EXPECT_NEAR(moved_on(turning, 1.2).heading, 0.1, 1e-12);
  EXPECT_NEAR(moved_on(turning, 1.2).p_WR.y(), 0.08 * std::sin(0.05), 1e-12);
}

TEST(LiveScore, TakesTheNewestPoseAndNoneFromTheFuture) {
  const TruePath path = standing({0.0, 0.0});
  const LiveScore score =
      score_live({estimate_at(path, 1.0, {0.1, 0.0}), estimate_at(path, 2.0)}, path, {1.9, 2.0}, kNeverSettled);
  EXPECT_NEAR(score.all[0], 0.1, 1e-12);
  EXPECT_NEAR(score.all[1], 0.0, 1e-12);
}

TEST(LiveScore, CountsSamplesBeforeAnyPose) {
  const TruePath path = standing({0.0, 0.0});
  const LiveScore score = score_live({estimate_at(path, 1.0)}, path, {0.5, 0.9, 1.0}, 0.0);
  EXPECT_EQ(score.without_pose, 2);
  EXPECT_EQ(score.all.size(), 1U);
}

TEST(LiveScore, TellsTheSettledSamplesApart) {
  const TruePath path = standing({0.0, 0.0});
  const LiveScore score = score_live({estimate_at(path, 0.0, {0.1, 0.0}), estimate_at(path, 1.0, {0.01, 0.0})}, path,
                                     {0.0, 0.5, 1.0, 1.5}, 1.0);
  ASSERT_EQ(score.settled.size(), 2U);
  EXPECT_NEAR(score.settled[0], 0.01, 1e-12);
}

TEST(LiveScore, AsksForAHeadingWhileDrivingOnlyAndTheShortWayRound) {
  const TruePath path = straight({0.0, 0.0}, 3.1, 0.4, 10.0);
  PoseEstimate estimate = estimate_at(path, 0.0);
  estimate.heading = -3.1;
  const LiveScore score = score_live({estimate}, path, {0.0}, 0.0);
  ASSERT_EQ(score.settled_heading.size(), 1U);
  EXPECT_NEAR(score.settled_heading[0], 2.0 * M_PI - 6.2, 1e-9);
  const TruePath still = standing({0.0, 0.0});
  EXPECT_TRUE(score_live({estimate_at(still, 0.0)}, still, {0.0}, 0.0).settled_heading.empty());
}

TEST(LiveScore, WeighsTheErrorByThePublishedCovariance) {
  const TruePath path = straight({0.0, 0.0}, 0.0, 0.4, 10.0);
  PoseEstimate estimate = estimate_at(path, 0.0, {0.02, 0.01});
  estimate.heading = 0.1;
  estimate.covariance.diagonal() << 0.01 * 0.01, 0.01 * 0.01, 0.05 * 0.05;
  const LiveScore score = score_live({estimate}, path, {0.0}, 0.0);
  ASSERT_EQ(score.settled_nees.size(), 1U);
  EXPECT_NEAR(score.settled_nees[0], 4.0 + 1.0 + 4.0, 1e-9);
}

TEST(LiveScore, ScoresACovarianceOnlyWhereThePoseClaimsToBeLocalised) {
  const TruePath path = standing({0.0, 0.0});
  PoseEstimate estimate = estimate_at(path, 0.0);
  estimate.localised = false;
  const LiveScore score = score_live({estimate}, path, {0.0, 0.1}, 0.0);
  EXPECT_TRUE(score.settled_nees.empty());
  EXPECT_EQ(score.settled_not_localised, 2);
  EXPECT_EQ(score.settled.size(), 2U);
}

TEST(LiveScore, CallsARunDivergedAfterTwoFarSamplesInARow) {
  const TruePath path = standing({0.0, 0.0});
  const auto diverged = [&](const std::vector<double>& errors, double settled_from) {
    std::vector<PoseEstimate> estimates;
    std::vector<double> times;
    for (const double error : errors) {
      times.push_back(static_cast<double>(times.size()));
      estimates.push_back(estimate_at(path, times.back(), {error, 0.0}));
    }
    return score_live(estimates, path, times, settled_from).diverged;
  };
  EXPECT_TRUE(diverged({0.01, 0.16, 0.16}, 0.0));
  EXPECT_FALSE(diverged({0.16, 0.01, 0.16}, 0.0));
  EXPECT_FALSE(diverged({0.14, 0.14, 0.14}, 0.0));
  EXPECT_FALSE(diverged({0.16, 0.16, 0.01}, 1.0));
  EXPECT_TRUE(diverged({0.01, NAN, NAN}, 0.0));
}

TEST(LiveScore, RefusesEstimatesOutOfOrder) {
  const TruePath path = standing({0.0, 0.0});
  EXPECT_THROW(score_live({estimate_at(path, 1.0), estimate_at(path, 0.0)}, path, {1.0}, 0.0), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::experiments
