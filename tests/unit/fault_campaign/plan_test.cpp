#include "tests/system/fault_campaign/plan.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/system/fault_campaign/random.hpp"
#include "tests/system/fault_campaign/results.hpp"

namespace markservo::campaign {
namespace {

std::string words(const Plan& plan) {
  std::string words = plan.phase;
  for (const FaultPlan& fault : plan.faults) words += " " + json_of(fault).dump();
  return words;
}

TEST(Random, IsSplitMix64) {
  // The first outputs for seed 1234567, from the generator's reference implementation.
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317ULL);
  EXPECT_EQ(random.next(), 3203168211198807973ULL);
}

TEST(Plan, OfASeedIsAlwaysTheSame) {
  for (std::int64_t seed = 1; seed <= 50; ++seed) EXPECT_EQ(words(plan_of(seed, 0)), words(plan_of(seed, 0)));
  EXPECT_NE(words(plan_of(1, 0)), words(plan_of(2, 0)));
  EXPECT_NE(words(plan_of(1, 0)), words(plan_of(1, 1)));
}

TEST(Plan, ReachesEveryPhaseAndKindOfFault) {
  std::set<std::string> seen_phases;
  std::set<std::string> seen_kinds;
  for (std::int64_t seed = 1; seed <= 200; ++seed) {
    const Plan plan = plan_of(seed, 0);
    ASSERT_GE(plan.faults.size(), 1U);
    ASSERT_LE(plan.faults.size(), 3U);
    seen_phases.insert(plan.phase);
    for (const FaultPlan& fault : plan.faults) seen_kinds.insert(fault.kind);
  }
  EXPECT_EQ(seen_phases.size(), phases().size());
  EXPECT_EQ(seen_kinds.size(), fault_kinds().size());
}

TEST(Plan, HangsLongInOneOfTwenty) {
  int hangs = 0;
  int longer = 0;
  for (std::int64_t seed = 1; seed <= 5000; ++seed) {
    for (const FaultPlan& fault : plan_of(seed, 0).faults) {
      if (fault.kind != "hang") continue;
      ++hangs;
      longer += fault.duration > 10.0 ? 1 : 0;
      EXPECT_GE(fault.duration, 0.1);
      EXPECT_LE(fault.duration, 60.0);
    }
  }
  ASSERT_GT(hangs, 200);
  EXPECT_GT(longer, hangs / 50);
  EXPECT_LT(longer, hangs / 10);
}

TEST(Plan, CanBeAskedForOneFault) {
  const Plan plan = plan_with(3, "second-writer:JOINT_STATE:other", "servo");
  ASSERT_EQ(plan.faults.size(), 1U);
  EXPECT_EQ(plan.faults[0].channel, "JOINT_STATE");
  EXPECT_FALSE(plan.faults[0].same_session);
  EXPECT_EQ(plan.phase, "servo");
  EXPECT_THROW(plan_with(3, "earthquake", "servo"), std::invalid_argument);
  EXPECT_THROW(plan_with(3, "second-writer:NO_CHANNEL", "servo"), std::invalid_argument);
  EXPECT_THROW(plan_with(3, "kill", "lunch"), std::invalid_argument);
}

nlohmann::json trial(std::int64_t seed) {
  return {{"seed", seed},
          {"phase", "idle"},
          {"phase_reached", true},
          {"struck", true},
          {"faults", nlohmann::json::array()}};
}

Verdict broken_verdict() {
  Verdict verdict;
  verdict.judged = 3;
  note(verdict, 1, "it moved");
  return verdict;
}

TEST(Results, CountSeedsThatBroke) {
  const auto good = result_of(trial(1), {{"I2", Verdict{5, {}}}});
  const auto bad = result_of(trial(2), {{"I2", broken_verdict()}, {"I7", broken_verdict()}});
  const auto campaign = campaign_of("abc", {good, bad});
  EXPECT_EQ(campaign.at("totals").at("I2").at("judged"), 8);
  EXPECT_EQ(campaign.at("totals").at("I2").at("broken"), 1);
  EXPECT_EQ(campaign.at("seeds").at(1).at("broken"), nlohmann::json({"I2", "I7"}));
  EXPECT_FALSE(bars_met(campaign, 2));
}

TEST(Results, AllowAFewOfHealthButNoneOfMotion) {
  EXPECT_TRUE(bars_met(campaign_of("abc", {result_of(trial(1), {{"I7", broken_verdict()}})}), 2));
  EXPECT_FALSE(bars_met(campaign_of("abc", {result_of(trial(1), {{"I7", broken_verdict()}})}), 0));
  EXPECT_FALSE(bars_met(campaign_of("abc", {result_of(trial(1), {{"I1", broken_verdict()}})}), 2));
}

TEST(Results, ASeedThatStruckNothingProvesNothing) {
  nlohmann::json nothing = trial(1);
  nothing["struck"] = false;
  EXPECT_FALSE(bars_met(campaign_of("abc", {result_of(nothing, {})}), 2));
}

TEST(Results, ABreachOfWhatMayNeverBreakCountsInADrawThatProvedNothing) {
  auto unreached = trial(1);
  unreached["phase_reached"] = false;
  EXPECT_TRUE(breaks_what_may_never_break(result_of(unreached, {{"I4", broken_verdict()}})));
  EXPECT_FALSE(breaks_what_may_never_break(result_of(unreached, {{"I7", broken_verdict()}})));
  EXPECT_FALSE(breaks_what_may_never_break(result_of(unreached, {})));
  EXPECT_NE(line_of(result_of(unreached, {{"I4", broken_verdict()}})).find("I4"), std::string::npos);
}

}  // namespace
}  // namespace markservo::campaign
