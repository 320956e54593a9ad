#include "services/rfid-localizer/wheel_report.hpp"

#include <gtest/gtest.h>

#include "common/geometry/degrees.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr std::size_t kLongestText = 200;  // bytes

WheelJudgement judged(double drift_deg, bool drift_small, double wander, bool wander_small) {
  return {{geometry::radians(2.0), geometry::radians(drift_deg), drift_small}, {0.0, wander, wander_small}};
}

TEST(WheelReport, SaysNothingOfWheelsAsStated) {
  EXPECT_EQ(describe(judged(2.3, false, 0.001, false)), "");
}

TEST(WheelReport, NamesTheNumberByHowMuchItIsWrongAndWhatFits) {
  EXPECT_EQ(describe(judged(8.2, true, 0.0, false)),
            "base.odometry.drift_deg_per_sqrt_m is 2, 4.1 times too small: 8.2 deg/sqrt(m) would fit");
  EXPECT_EQ(describe(judged(2.0, false, 0.0213, true)), "base.odometry.pivot_wander is 0, 0.021 m/sqrt(rad) would fit");
  WheelJudgement stated_wander = judged(2.0, false, 0.03, true);
  stated_wander.pivot_wander.stated = 0.01;
  EXPECT_EQ(describe(stated_wander),
            "base.odometry.pivot_wander is 0.01, 3.0 times too small: 0.03 m/sqrt(rad) would fit");
}

TEST(WheelReport, ProposesWhatItNamesAndNothingElse) {
  const WheelProposal both = proposal(judged(8.237, true, 0.0213, true));
  EXPECT_DOUBLE_EQ(both.drift_deg_per_sqrt_m.value(), 8.2);
  EXPECT_DOUBLE_EQ(both.pivot_wander.value(), 0.021);
  EXPECT_DOUBLE_EQ(proposal(judged(9.96, true, 0.0, false)).drift_deg_per_sqrt_m.value(), 10.0);
  EXPECT_DOUBLE_EQ(proposal(judged(12.4, true, 0.0, false)).drift_deg_per_sqrt_m.value(), 12.0);
  const WheelProposal none = proposal(judged(2.9, false, 0.004, false));
  EXPECT_FALSE(none.drift_deg_per_sqrt_m);
  EXPECT_FALSE(none.pivot_wander);
}

TEST(WheelReport, NamesBothInOneShortText) {
  const std::string text = describe(judged(8.2, true, 0.0213, true));
  EXPECT_NE(text.find("drift_deg_per_sqrt_m"), std::string::npos);
  EXPECT_NE(text.find("pivot_wander"), std::string::npos);
  EXPECT_LE(text.size(), kLongestText);
}

TEST(WheelReport, TellsNewsOnly) {
  WheelReport report;
  EXPECT_EQ(report.news(judged(2.2, false, 0.0, false)), "");
  EXPECT_NE(report.news(judged(5.0, true, 0.0, false)), "");
  EXPECT_EQ(report.news(judged(5.5, true, 0.0, false)), "") << "much the same";
  EXPECT_NE(report.news(judged(8.0, true, 0.0, false)), "") << "a number that would fit better";
  EXPECT_NE(report.news(judged(8.0, true, 0.02, true)), "") << "another number";
  EXPECT_NE(report.news(judged(2.0, false, 0.02, true)), "");
  EXPECT_EQ(report.news(judged(2.0, false, 0.0, false)), "the wheels are as good as robot.yaml states");
  EXPECT_EQ(report.news(judged(2.0, false, 0.0, false)), "");
}

}  // namespace
}  // namespace markservo::rfid_localizer
