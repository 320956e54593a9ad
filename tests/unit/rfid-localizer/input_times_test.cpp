#include "services/rfid-localizer/input_times.hpp"

#include <gtest/gtest.h>

namespace markservo::rfid_localizer {
namespace {

constexpr std::int64_t kSession = 5;

InputTimes after(std::int64_t utime) {
  InputTimes times;
  times.accept(utime, kSession);
  return times;
}

TEST(InputTimes, GoOnFromTheFirstMessageWheneverThatIs) {
  InputTimes times;
  EXPECT_EQ(times.judge(1000, kSession), InputTimes::Step::kOn);
  times.accept(1000, kSession);
  EXPECT_EQ(times.judge(1001, kSession), InputTimes::Step::kOn);
  EXPECT_EQ(times.last(), 1000);
}

TEST(InputTimes, TakeWhatIsNotAfterTheLastForLate) {
  InputTimes times = after(1000);
  EXPECT_EQ(times.judge(1000, kSession), InputTimes::Step::kLate);
  EXPECT_EQ(times.judge(999, kSession), InputTimes::Step::kLate);
  EXPECT_EQ(times.last(), 1000);
}

TEST(InputTimes, BeginAnewWithAnotherDriver) {
  EXPECT_EQ(after(1000).judge(1, kSession + 1), InputTimes::Step::kAnew);
}

TEST(InputTimes, BeginAnewWhenTwentyWereLateInARow) {
  InputTimes times = after(1000);
  for (int i = 1; i <= 20; ++i) EXPECT_EQ(times.judge(i, kSession), InputTimes::Step::kLate);
  EXPECT_EQ(times.judge(21, kSession), InputTimes::Step::kAnew);
  times.accept(21, kSession);
  EXPECT_EQ(times.judge(21, kSession), InputTimes::Step::kLate) << "the count begins anew too";
}

TEST(InputTimes, CountLateOnesInARowOnly) {
  InputTimes times = after(1000);
  for (int i = 0; i < 19; ++i) times.judge(1, kSession);
  times.accept(1001, kSession);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(times.judge(1, kSession), InputTimes::Step::kLate);
}

TEST(InputTimes, ForgetTheLast) {
  InputTimes times = after(1000);
  times.forget();
  EXPECT_FALSE(times.last().has_value());
  EXPECT_EQ(times.judge(1, kSession), InputTimes::Step::kOn);
}

}  // namespace
}  // namespace markservo::rfid_localizer
