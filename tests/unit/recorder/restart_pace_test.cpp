#include "services/recorder/logger/restart_pace.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace markservo::recorder {
namespace {

TEST(RestartPace, GrowsWhileOneAfterTheOtherDiesSoon) {
  RestartPace pace;
  std::vector<std::int64_t> pauses_ms;
  for (int i = 0; i < 8; ++i) pauses_ms.push_back(pace.pause_us(1'000'000) / 1000);
  EXPECT_EQ(pauses_ms, (std::vector<std::int64_t>{0, 500, 1000, 2000, 2000, 2000, 2000, 2000}));
}

TEST(RestartPace, BeginsAnewAfterOneThatLived) {
  RestartPace pace;
  for (int i = 0; i < 8; ++i) pace.pause_us(1'000'000);
  EXPECT_EQ(pace.pause_us(10'000'001), 0);
  EXPECT_EQ(pace.pause_us(1'000'000), 0);
  EXPECT_EQ(pace.pause_us(1'000'000), 500'000);
}

}  // namespace
}  // namespace markservo::recorder
