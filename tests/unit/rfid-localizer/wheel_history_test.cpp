#include "services/rfid-localizer/wheel_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace markservo::rfid_localizer {
namespace {

constexpr std::int64_t kEpoch = 50'000'000;
constexpr std::int64_t kPeriod = 20'000;

// Speeds up evenly and turns ever more: no two pieces are alike.
WheelMotion piece_number(int i) {
  return {0.001 * i, 0.0005 * i * i, 0.02, 0.0};
}

WheelHistory drive(int pieces) {
  WheelHistory history;
  for (int i = 0; i <= pieces; ++i) history.add(kEpoch + i * kPeriod, piece_number(i));
  return history;
}

WheelMotion sum(const WheelHistory& history, std::int64_t from, std::int64_t to) {
  WheelMotion all;
  double unknown_variance = 0.0;
  history.replay(from, to, [&](const WheelMotion& piece) {
    all.way += piece.way;
    all.turn += piece.turn;
    all.time += piece.time;
    unknown_variance += piece.unknown_way * piece.unknown_way;
  });
  all.unknown_way = std::sqrt(unknown_variance);
  return all;
}

TEST(WheelHistory, OfWholePiecesIsTheirSum) {
  const WheelHistory history = drive(20);
  WheelMotion expected;
  for (int i = 6; i <= 15; ++i) {
    expected.way += piece_number(i).way;
    expected.turn += piece_number(i).turn;
  }
  const WheelMotion motion = sum(history, kEpoch + 5 * kPeriod, kEpoch + 15 * kPeriod);
  EXPECT_NEAR(motion.way, expected.way, 1e-12);
  EXPECT_NEAR(motion.turn, expected.turn, 1e-12);
  EXPECT_NEAR(motion.time, 0.2, 1e-12);
}

TEST(WheelHistory, AddsUpTheSameHoweverItIsCut) {
  const WheelHistory history = drive(40);
  const std::int64_t from = kEpoch + 33'333;
  const std::int64_t to = kEpoch + 40 * kPeriod + 150'000;
  const WheelMotion whole = sum(history, from, to);
  for (const std::int64_t step : {777, 13'000, 20'000, 250'000}) {
    WheelMotion parts;
    for (std::int64_t begin = from; begin < to; begin += step) {
      const WheelMotion part = sum(history, begin, std::min(begin + step, to));
      parts.way += part.way;
      parts.turn += part.turn;
      parts.time += part.time;
    }
    EXPECT_NEAR(parts.way, whole.way, 1e-9) << step;
    EXPECT_NEAR(parts.turn, whole.turn, 1e-9) << step;
    EXPECT_NEAR(parts.time, whole.time, 1e-9) << step;
  }
}

TEST(WheelHistory, GoesOnAsInItsLastPieceForAFifthOfASecondAndNoLonger) {
  const WheelHistory history = drive(10);
  const std::int64_t end = kEpoch + 10 * kPeriod;
  EXPECT_NEAR(sum(history, end, end + 60'000).way, 3.0 * piece_number(10).way, 1e-12);
  const double most = 10.0 * piece_number(10).way;
  EXPECT_NEAR(sum(history, end, end + 200'000).way, most, 1e-12);
  EXPECT_NEAR(sum(history, end, end + 5'000'000).way, most, 1e-12);
  EXPECT_NEAR(sum(history, end + 300'000, end + 5'000'000).way, 0.0, 1e-12);
}

TEST(WheelHistory, KnowsOfNoMotionBeforeItBegins) {
  const WheelHistory history = drive(10);
  EXPECT_EQ(sum(history, 0, kEpoch).time, 0.0);
  EXPECT_NEAR(sum(history, 0, kEpoch + kPeriod).way, piece_number(1).way, 1e-12) << "the first sample moved nothing";
}

TEST(WheelHistory, WithoutTwoSamplesOrWithoutTimeTellsNothing) {
  WheelHistory history;
  EXPECT_EQ(sum(history, 0, kEpoch).time, 0.0);
  EXPECT_EQ(history.rate(0, kEpoch).way, 0.0);
  history.add(kEpoch, {1.0, 1.0, 1.0, 1.0});
  EXPECT_EQ(sum(history, kEpoch - 1, kEpoch + 1000).time, 0.0);
  history.add(kEpoch + kPeriod, piece_number(1));
  EXPECT_EQ(sum(history, kEpoch + 100, kEpoch + 100).time, 0.0);
  EXPECT_EQ(sum(history, kEpoch + 200, kEpoch + 100).time, 0.0);
}

TEST(WheelHistory, IsTrimmedButKeepsAllThatItPromises) {
  WheelHistory history;
  const int pieces = 3000;  // a minute
  for (int i = 0; i <= pieces; ++i) history.add(kEpoch + i * kPeriod, {0.004, 0.0, 0.02, 0.0});
  const std::int64_t end = kEpoch + pieces * kPeriod;
  EXPECT_EQ(history.newest(), end);
  EXPECT_LE(history.oldest(), end - WheelHistory::kKept_us);
  EXPECT_GE(history.oldest(), end - WheelHistory::kKept_us - 2 * kPeriod);
  const double kept = 1e-6 * static_cast<double>(WheelHistory::kKept_us);
  EXPECT_NEAR(sum(history, end - WheelHistory::kKept_us, end).way, 0.2 * kept, 1e-9);
}

TEST(WheelHistory, KeepsThePieceThatEndsAGapLongerThanItself) {
  WheelHistory history = drive(10);
  history.add(kEpoch + 60'000'000, {6.0, 0.0, 59.8, 0.0});
  EXPECT_NEAR(sum(history, kEpoch + 10 * kPeriod, kEpoch + 60'000'000).way, 6.0, 1e-9);
}

TEST(WheelHistory, TellsRatesAsAverages) {
  const WheelHistory history = drive(20);
  const WheelMotion rate = history.rate(kEpoch + 4 * kPeriod, kEpoch + 6 * kPeriod);
  EXPECT_NEAR(rate.way, 0.5 * (piece_number(5).way + piece_number(6).way) / 0.02, 1e-12);
  EXPECT_NEAR(rate.turn, 0.5 * (piece_number(5).turn + piece_number(6).turn) / 0.02, 1e-12);
}

TEST(WheelHistory, AnUnknownWayIsAsUncertainInPartsAsWhole) {
  WheelHistory history;
  history.add(kEpoch, {});
  history.add(kEpoch + 400'000, {0.0, 0.0, 0.4, 0.5});
  history.add(kEpoch + 420'000, {0.0, 0.0, 0.02, 0.0});
  EXPECT_NEAR(sum(history, kEpoch, kEpoch + 400'000).unknown_way, 0.5, 1e-12);
  const double first = sum(history, kEpoch, kEpoch + 100'000).unknown_way;
  const double rest = sum(history, kEpoch + 100'000, kEpoch + 410'000).unknown_way;
  EXPECT_NEAR(std::hypot(first, rest), 0.5, 1e-12);
}

}  // namespace
}  // namespace markservo::rfid_localizer
