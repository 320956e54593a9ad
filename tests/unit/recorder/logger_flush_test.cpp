#include "services/recorder/logger/logger_flush.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

constexpr std::int64_t kTold_us = 5'000'000;
constexpr std::int64_t kMillisecond_us = 1000;
const LoggerThreads kWrites{"do_sys_poll", "folio_wait_bit_common"};
const LoggerThreads kWaits{"do_sys_poll", "futex_wait_queue"};
const LoggerThreads kUntold{"0", "0"};

bool has_written(LoggerFlush* flush, const LoggerThreads& threads, std::int64_t after_ms) {
  return flush->has_written(threads, kTold_us + after_ms * kMillisecond_us);
}

TEST(LoggerFlush, LetsWhatIsOnItsWayComeIn) {
  LoggerFlush flush(kTold_us);
  EXPECT_FALSE(has_written(&flush, kWaits, 0));
  EXPECT_FALSE(has_written(&flush, kWaits, 299));
  EXPECT_TRUE(has_written(&flush, kWaits, 300));
}

TEST(LoggerFlush, TakesAsLongAsTheSecondThreadHasSomethingToWrite) {
  LoggerFlush flush(kTold_us);
  EXPECT_FALSE(has_written(&flush, kWrites, 300));
  EXPECT_FALSE(has_written(&flush, kWrites, 20'000));
  EXPECT_FALSE(has_written(&flush, {"do_sys_poll", "0"}, 20'050)) << "it runs";
  EXPECT_TRUE(has_written(&flush, kWaits, 20'100));
}

TEST(LoggerFlush, TakesNoLongerThanADiskThatWorksNeeds) {
  LoggerFlush flush(kTold_us);
  EXPECT_FALSE(has_written(&flush, kWrites, 30'299));
  EXPECT_TRUE(has_written(&flush, kWrites, 30'300));
}

TEST(LoggerFlush, TakesASecondWhereTheKernelDoesNotTell) {
  LoggerFlush flush(kTold_us);
  EXPECT_FALSE(has_written(&flush, kUntold, 300));
  EXPECT_FALSE(has_written(&flush, kUntold, 999));
  EXPECT_TRUE(has_written(&flush, kUntold, 1000));
}

TEST(LoggerFlush, IsOverWhereNothingWrites) {
  LoggerFlush flush(kTold_us);
  EXPECT_TRUE(has_written(&flush, {"do_sys_poll", std::nullopt}, 300));
}

}  // namespace
}  // namespace markservo::recorder
