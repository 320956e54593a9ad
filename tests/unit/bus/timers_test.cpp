#include "common/bus/timers.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::bus {
namespace {

using std::chrono::milliseconds;

const Timers::Time kStart{std::chrono::seconds(1000)};

void ignore(const char* /*what*/) {}

TEST(Timers, CallATaskOncePerPeriodFromOnePeriodOn) {
  Timers timers;
  int calls = 0;
  timers.add(
      milliseconds(100), [&] { ++calls; }, kStart);
  timers.run(kStart + milliseconds(99), ignore);
  EXPECT_EQ(calls, 0);
  timers.run(kStart + milliseconds(100), ignore);
  timers.run(kStart + milliseconds(101), ignore);
  EXPECT_EQ(calls, 1);
  timers.run(kStart + milliseconds(200), ignore);
  EXPECT_EQ(calls, 2);
}

TEST(Timers, DoNotCatchUpOnWhatWasMissed) {
  Timers timers;
  int calls = 0;
  timers.add(
      milliseconds(100), [&] { ++calls; }, kStart);
  timers.run(kStart + milliseconds(1050), ignore);
  timers.run(kStart + milliseconds(1100), ignore);
  EXPECT_EQ(calls, 1);
}

TEST(Timers, SayHowLongItIsUntilTheNextAtMostTheLimit) {
  Timers timers;
  EXPECT_EQ(timers.until_next(milliseconds(70), kStart), milliseconds(70));
  timers.add(
      milliseconds(100), [] {}, kStart);
  timers.add(
      milliseconds(50), [] {}, kStart);
  EXPECT_EQ(timers.until_next(milliseconds(70), kStart), milliseconds(50));
  EXPECT_EQ(timers.until_next(milliseconds(20), kStart), milliseconds(20));
  EXPECT_EQ(timers.until_next(milliseconds(70), kStart + milliseconds(500)), milliseconds(0));
}

TEST(Timers, GoOnAfterATaskThatThrows) {
  Timers timers;
  int calls = 0;
  std::string told;
  timers.add(
      milliseconds(10), [] { throw std::runtime_error("no ink"); }, kStart);
  timers.add(
      milliseconds(10), [&] { ++calls; }, kStart);
  timers.run(kStart + milliseconds(10), [&](const char* what) { told = what; });
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(told, "no ink");
}

}  // namespace
}  // namespace markservo::bus
