// The time of a task: what counts and what does not.

#include "services/task-manager/task_clock.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kBegin = 1'000'000'000;  // us
constexpr std::int64_t kFrame_us = 33'333;

TEST(TaskClock, CountsFrames) {
  TaskClock clock;
  clock.advance(kBegin);
  const std::int64_t begin = clock.now();
  EXPECT_EQ(clock.advance(kBegin + kFrame_us).passed_over_us, 0);
  EXPECT_EQ(clock.now() - begin, kFrame_us);
  EXPECT_EQ(clock.at(kBegin + kFrame_us), clock.now());
}

TEST(TaskClock, CountsOfEachGapAsMuchAsGoalsMayAge) {
  TaskClock clock;
  clock.advance(kBegin);
  const std::int64_t begin = clock.now();
  EXPECT_EQ(clock.advance(kBegin + 600'000).passed_over_us, 0);
  EXPECT_EQ(clock.now() - begin, 600'000);
  EXPECT_EQ(clock.advance(kBegin + 1'200'001).passed_over_us, 1);
  EXPECT_EQ(clock.now() - begin, 1'200'000);
  EXPECT_EQ(clock.advance(kBegin + 11'200'001).passed_over_us, 9'400'000);
  EXPECT_EQ(clock.now() - begin, 1'800'000);
  clock.advance(kBegin + 11'200'001 + kFrame_us);
  EXPECT_EQ(clock.now() - begin, 1'800'000 + kFrame_us);
}

TEST(TaskClock, TakesAMessageFromBeforeAPauseForAsOldAsThePauseIsLong) {
  TaskClock clock;
  clock.advance(kBegin);
  clock.advance(kBegin + 10'000'000);
  EXPECT_EQ(clock.now() - clock.at(kBegin + 1), 10'000'000 - 1);
}

TEST(TaskClock, TellsWhenItIsSetBackByMoreThanASecond) {
  TaskClock clock;
  EXPECT_FALSE(clock.advance(kBegin).set_back);
  EXPECT_FALSE(clock.advance(kBegin - 1'000'000).set_back);
  EXPECT_TRUE(clock.advance(kBegin - 2'000'001).set_back);
  EXPECT_FALSE(clock.advance(kBegin - 2'000'001 + kFrame_us).set_back);
}

}  // namespace
}  // namespace markservo::task_manager
