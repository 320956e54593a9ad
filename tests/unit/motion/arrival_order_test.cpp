// The table of arrival_order.hpp, walked through.

#include "common/motion/arrival_order.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace markservo::motion {
namespace {

constexpr std::int64_t kSession = 7;
constexpr std::int64_t kStart = 1'000'000'000;

Stamp at(std::int64_t seq, std::int64_t ms) {
  return {kSession, seq, kStart + 1000 * ms};
}

// A writer at 100 Hz that has sent ten.
ArrivalOrder after_ten() {
  ArrivalOrder order;
  for (int i = 1; i <= 10; ++i) EXPECT_EQ(order.hear(at(i, 10 * i)), Arrival::kNext);
  return order;
}

TEST(ArrivalOrder, TakesWhatGrows) {
  ArrivalOrder order = after_ten();
  EXPECT_EQ(order.hear(at(11, 110)), Arrival::kNext);
  EXPECT_EQ(order.hear(at(20, 200)), Arrival::kNext) << "what lies between is lost, or comes late";
}

TEST(ArrivalOrder, TakesAnotherNumberOfTheSameTime) {
  EXPECT_EQ(after_ten().hear(at(11, 100)), Arrival::kNext) << "in lockstep time stands while a message is sent again";
}

TEST(ArrivalOrder, DropsWhatComesTwiceOrLate) {
  ArrivalOrder order = after_ten();
  EXPECT_EQ(order.hear(at(10, 100)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(7, 70)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(11, 110)), Arrival::kNext);
}

TEST(ArrivalOrder, NeverTakesSingleLateOnesForABeginning) {
  ArrivalOrder order = after_ten();
  for (int i = 11; i < 200; ++i) {
    ASSERT_EQ(order.hear(at(i, 10 * i)), Arrival::kNext);
    ASSERT_EQ(order.hear(at(i - 3, 10 * (i - 3))), Arrival::kLate);
  }
}

TEST(ArrivalOrder, ThreeInARowThatGrowBeginAnew) {
  ArrivalOrder order = after_ten();
  EXPECT_EQ(order.hear(at(1, 10)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(2, 20)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(3, 30)), Arrival::kAnew);
  EXPECT_EQ(order.hear(at(4, 40)), Arrival::kNext);
}

TEST(ArrivalOrder, ThreeInARowThatDoNotGrowBeginNothing) {
  ArrivalOrder order = after_ten();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(order.hear(at(5, 50)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(9, 90)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(8, 80)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(7, 70)), Arrival::kLate);
}

TEST(ArrivalOrder, AnOldRecordingOfTheSameWriterBeginsNothing) {
  ArrivalOrder order;
  for (int i = 500; i <= 510; ++i) order.hear(at(i, 10 * i));
  for (int i = 1; i < 100; ++i) EXPECT_EQ(order.hear(at(i, 10 * i)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(511, 5110)), Arrival::kNext);
}

TEST(ArrivalOrder, AClockSetBackByMoreThanASecondBeginsAnewAtOnce) {
  EXPECT_EQ(after_ten().hear(at(11, 110 - 3'600'000)), Arrival::kAnew);
}

TEST(ArrivalOrder, AClockSetBackByLessBeginsAnewAfterThree) {
  ArrivalOrder order = after_ten();
  EXPECT_EQ(order.hear(at(11, -400)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(12, -390)), Arrival::kLate);
  EXPECT_EQ(order.hear(at(13, -380)), Arrival::kAnew);
}

TEST(ArrivalOrder, ALaterTimeUnderAUsedNumberIsAnotherWriters) {
  EXPECT_EQ(after_ten().hear(at(10, 105)), Arrival::kDouble);
  EXPECT_EQ(after_ten().hear(at(3, 105)), Arrival::kDouble);
}

TEST(ArrivalOrder, AnotherTimeUnderAUsedNumberIsAnotherWritersThoughItIsEarlier) {
  ArrivalOrder order;
  EXPECT_EQ(order.hear(at(1, 10)), Arrival::kNext);
  EXPECT_EQ(order.hear(at(2, 21)), Arrival::kNext) << "forged, right before the writer's own";
  EXPECT_EQ(order.hear(at(2, 20)), Arrival::kDouble);
  EXPECT_EQ(order.hear(at(2, 21)), Arrival::kLate) << "a repetition is none";
}

TEST(ArrivalOrder, OtherWordsUnderAUsedNumberAndTimeAreAnotherWriters) {
  ArrivalOrder order;
  const auto says = [](std::uint64_t content) { return Stamp{kSession, 1, kStart, content}; };
  EXPECT_EQ(order.hear(says(11)), Arrival::kNext);
  EXPECT_EQ(order.hear(says(11)), Arrival::kLate) << "a repetition";
  EXPECT_EQ(order.hear(says(22)), Arrival::kDouble);
  EXPECT_EQ(order.hear(says(0)), Arrival::kLate) << "what it says is not known";
}

TEST(ArrivalOrder, OneOfTwoWithOneSessionIsTheWriterAgainWhenTheOtherWithTheHigherNumbersIsGone) {
  ArrivalOrder order = after_ten();
  for (int i = 11; i <= 20; ++i) {
    EXPECT_EQ(order.hear(at(1000 + i, 10 * i)), Arrival::kNext);
    EXPECT_EQ(order.hear(at(i, 10 * i + 5)), Arrival::kDouble) << "as long as both speak";
  }
  EXPECT_EQ(order.hear(at(21, 215)), Arrival::kDouble);
  EXPECT_EQ(order.hear(at(22, 225)), Arrival::kAnew);
  EXPECT_EQ(order.hear(at(23, 235)), Arrival::kNext);
}

}  // namespace
}  // namespace markservo::motion
