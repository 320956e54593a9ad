#include "tests/experiments/localisation/localisation_bars.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace markservo::experiments {
namespace {

CaseResult result_with(const CaseBars& bars) {
  CaseResult result;
  result.the_case.bars = bars;
  result.with_encoders.settled = {0.010, 0.012};
  result.with_encoders.bound_settled = {0.010, 0.010};
  result.with_encoders.nees = {3.0};
  return result;
}

// The verdict that begins like this.
Verdict verdict(const CaseResult& result, const std::string& what, std::optional<double> hall_mean = std::nullopt) {
  for (const Verdict& candidate : verdicts(result, hall_mean)) {
    if (candidate.what.rfind(what, 0) == 0) return candidate;
  }
  ADD_FAILURE() << "no verdict on " << what;
  return {};
}

TEST(LocalisationBars, HoldTheMeanToItsBar) {
  CaseBars bars;
  bars.settled_mean = 0.0115;
  EXPECT_TRUE(verdict(result_with(bars), "mean error, settled").met());
  EXPECT_NEAR(verdict(result_with(bars), "mean error, settled").value, 1.1, 1e-9);
  bars.settled_mean = 0.0105;
  EXPECT_FALSE(verdict(result_with(bars), "mean error, settled").met());
}

TEST(LocalisationBars, HoldOursToTheBoundOfTheSameRuns) {
  CaseBars bars;
  bars.bound_ratio = 1.3;
  EXPECT_TRUE(verdict(result_with(bars), "ours over the bound").met());
  CaseResult worse = result_with(bars);
  worse.with_encoders.settled = {0.014};
  EXPECT_FALSE(verdict(worse, "ours over the bound").met());
}

TEST(LocalisationBars, HoldTheCovarianceToTheErrorsBothWays) {
  CaseBars bars;
  bars.nees = true;
  CaseResult result = result_with(bars);
  EXPECT_TRUE(verdict(result, "NEES").met());
  result.with_encoders.nees = {1.0};
  EXPECT_FALSE(verdict(result, "NEES").met());
  result.with_encoders.nees = {6.0};
  EXPECT_FALSE(verdict(result, "NEES").met());
}

TEST(LocalisationBars, HoldTheShareOfSamplesThatAreNotLocalised) {
  CaseBars bars;
  bars.not_localised_share = 0.02;
  CaseResult result = result_with(bars);
  result.with_encoders.settled = std::vector<double>(100, 0.010);
  result.with_encoders.not_localised = 2;
  EXPECT_TRUE(verdict(result, "samples not localised").met());
  result.with_encoders.not_localised = 3;
  EXPECT_FALSE(verdict(result, "samples not localised").met());
}

TEST(LocalisationBars, BoundTheShareNotLocalisedInEveryCaseOfDenseTags) {
  for (const LocalisationCase& each : localisation_cases()) {
    const double spacing = each.robot.spacing.value_or(0.10);
    if (spacing <= 0.10) {
      EXPECT_EQ(each.bars.not_localised_share, 0.02) << each.name;
    }
    EXPECT_EQ(each.bars.none(), each.name == "hall_d34") << each.name;
  }
}

TEST(LocalisationBars, MissWhatWasNotMeasured) {
  CaseBars bars;
  bars.heading_mean = 0.03;
  bars.free_mean = 0.02;
  EXPECT_FALSE(verdict(result_with(bars), "mean heading").met());
  EXPECT_FALSE(verdict(result_with(bars), "mean error without encoders").met());
}

TEST(LocalisationBars, CompareAStressWithTheHallWhereThatWasRun) {
  CaseBars bars;
  bars.hall_ratio = 1.5;
  const CaseResult result = result_with(bars);
  EXPECT_TRUE(verdict(result, "ours over the undisturbed hall", 0.010).met());
  EXPECT_FALSE(verdict(result, "ours over the undisturbed hall", 0.005).met());
  for (const Verdict& each : verdicts(result, std::nullopt)) EXPECT_NE(each.what, "ours over the undisturbed hall");
}

TEST(LocalisationBars, MissWhenARunDivergesOrASampleHasNoPose) {
  CaseBars bars;
  bars.must_not_diverge = true;
  CaseResult result = result_with(bars);
  EXPECT_TRUE(verdict(result, "runs diverged").met());
  EXPECT_TRUE(verdict(result, "samples without a pose").met());
  result.with_encoders.diverged = 1;
  result.with_encoders.without_pose = 1;
  EXPECT_FALSE(verdict(result, "runs diverged").met());
  EXPECT_FALSE(verdict(result, "samples without a pose").met());
}

}  // namespace
}  // namespace markservo::experiments
