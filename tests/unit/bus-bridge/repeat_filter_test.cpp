#include "services/bus-bridge/repeat_filter.hpp"

#include <gtest/gtest.h>

namespace markservo::bus_bridge {
namespace {

TEST(RepeatFilter, LetsTheSameBytesCrossOnceWithinItsWindow) {
  RepeatFilter filter;
  EXPECT_TRUE(filter.crosses(7, 0));
  EXPECT_FALSE(filter.crosses(7, 1'000));
  EXPECT_FALSE(filter.crosses(7, kRepeatWindow_us - 1));
}

TEST(RepeatFilter, LetsARepeatedCommandCrossAgain) {
  RepeatFilter filter;
  for (int repeat = 0; repeat < 5; ++repeat) EXPECT_TRUE(filter.crosses(7, repeat * 200'000));
}

TEST(RepeatFilter, CountsTheWindowFromTheMessageThatCrossed) {
  RepeatFilter filter;
  int crossed = 0;
  for (int i = 0; i < 100; ++i) crossed += filter.crosses(7, i * 10'000) ? 1 : 0;  // every 10 ms, for 1 s
  EXPECT_EQ(crossed, 10);
}

TEST(RepeatFilter, KeepsDifferentMessagesApart) {
  RepeatFilter filter;
  for (std::uint64_t message = 0; message < 1000; ++message) EXPECT_TRUE(filter.crosses(message, 0));
  for (std::uint64_t message = 0; message < 1000; ++message) EXPECT_FALSE(filter.crosses(message, 1));
}

TEST(RepeatFilter, RemembersABoundedNumberInAFlood) {
  RepeatFilter filter;
  for (std::uint64_t message = 0; message < 4096; ++message) filter.crosses(message, 0);
  EXPECT_FALSE(filter.crosses(0, 1));
  filter.crosses(5000, 1);
  EXPECT_TRUE(filter.crosses(0, 1));
}

}  // namespace
}  // namespace markservo::bus_bridge
