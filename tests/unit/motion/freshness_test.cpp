#include "common/motion/freshness.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

constexpr Freshness kRule{"SERVO_GOAL", "JOINT_STATE", 0.6, 0.3};
constexpr std::int64_t kNow = 1'000'000'000;

TEST(Freshness, HoldsUpToBothLimits) {
  EXPECT_EQ(why_not_fresh(kRule, kNow, kNow), "");
  EXPECT_EQ(why_not_fresh(kRule, kNow - 600'000, kNow), "");
  EXPECT_EQ(why_not_fresh(kRule, kNow + 300'000, kNow), "");
}

TEST(Freshness, SaysWhatIsTooOldOrTooFarAheadWithBothNumbers) {
  EXPECT_EQ(why_not_fresh(kRule, kNow - 720'000, kNow), "SERVO_GOAL is 0.72 s older than JOINT_STATE; allowed: 0.60 s");
  EXPECT_EQ(why_not_fresh(kRule, kNow + 310'000, kNow), "SERVO_GOAL is 0.31 s newer than JOINT_STATE; allowed: 0.30 s");
}

}  // namespace
}  // namespace markservo::motion
