#include "common/bus/time_line.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace markservo::bus {
namespace {

constexpr std::int64_t kNow = 1'700'000'000'000'000;
constexpr std::int64_t kHour = 3'600'000'000;

TEST(TimeLine, FollowsTheNewest) {
  TimeLine line;
  EXPECT_EQ(line.newest(), 0);
  EXPECT_TRUE(line.observe(kNow));
  EXPECT_TRUE(line.observe(kNow + 500'000));
  EXPECT_TRUE(line.observe(kNow + 300'000));
  EXPECT_EQ(line.newest(), kNow + 500'000);
}

TEST(TimeLine, DoesNotBelieveOneThatLies) {
  for (const std::int64_t lie : {std::int64_t{1}, kNow - kHour, kNow + kHour, std::int64_t{1} << 53}) {
    TimeLine line;
    line.observe(kNow);
    EXPECT_FALSE(line.observe(lie));
    EXPECT_EQ(line.newest(), kNow);
    EXPECT_TRUE(line.observe(kNow + 10'000));
    EXPECT_EQ(line.newest(), kNow + 10'000);
  }
}

TEST(TimeLine, DoesNotBelieveALiarBetweenOthers) {
  TimeLine line;
  line.observe(kNow);
  for (std::int64_t i = 1; i <= 100; ++i) {
    EXPECT_FALSE(line.observe(kNow + kHour + i));
    EXPECT_TRUE(line.observe(kNow + 10'000 * i));
  }
  EXPECT_EQ(line.newest(), kNow + 1'000'000);
}

TEST(TimeLine, BelievesThreeInARowAfterASilenceOrARestart) {
  for (const std::int64_t jump : {kHour, -kHour}) {
    TimeLine line;
    line.observe(kNow);
    EXPECT_FALSE(line.observe(kNow + jump));
    EXPECT_FALSE(line.observe(kNow + jump + 10'000));
    EXPECT_TRUE(line.observe(kNow + jump + 20'000));
    EXPECT_EQ(line.newest(), kNow + jump + 20'000);
  }
}

TEST(TimeLine, DoesNotBelieveThreeThatDisagree) {
  TimeLine line;
  line.observe(kNow);
  for (std::int64_t i = 1; i <= 10; ++i) EXPECT_FALSE(line.observe(kNow + i * kHour));
  EXPECT_EQ(line.newest(), kNow);
}

}  // namespace
}  // namespace markservo::bus
