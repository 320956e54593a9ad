#include "common/motion/sole_writer.hpp"

#include <gtest/gtest.h>

namespace markservo::motion {
namespace {

constexpr std::int64_t kStart = 1'000'000'000;

// One's messages, each of the time at which it comes.
struct Speaker {
  std::int64_t session;
  std::int64_t seq = 0;
  StreamHeard speak(SoleWriter& writer, double s) {
    const std::int64_t now = kStart + static_cast<std::int64_t>(1e6 * s);
    return writer.hear({session, ++seq, now}, now);
  }
};

std::int64_t now_at(double s) {
  return kStart + static_cast<std::int64_t>(1e6 * s);
}

class Writers : public testing::Test {
 protected:
  SoleWriter writer_{"TARGET_POSE"};
  Speaker one_{11};
  Speaker other_{22};
};

TEST_F(Writers, WhoSpeaksFirstIsHeardAtOnce) {
  EXPECT_EQ(one_.speak(writer_, 0.0), StreamHeard::kTaken);
  EXPECT_EQ(one_.speak(writer_, 0.1), StreamHeard::kTaken);
  EXPECT_TRUE(writer_.alone(now_at(0.1)));
}

TEST_F(Writers, ARestartedOneIsHeardOnceTheFloorHasBeenFree) {
  one_.speak(writer_, 0.0);
  EXPECT_EQ(other_.speak(writer_, 0.2), StreamHeard::kWaits);
  EXPECT_EQ(other_.speak(writer_, 0.31), StreamHeard::kAnew);
  EXPECT_EQ(other_.speak(writer_, 0.4), StreamHeard::kTaken);
  EXPECT_TRUE(writer_.alone(now_at(0.4))) << "what it said while it waited is not held against it";
}

TEST_F(Writers, TheFirstSpeakingAgainAfterAnotherMakesTwo) {
  one_.speak(writer_, 0.0);
  other_.speak(writer_, 0.05);
  EXPECT_EQ(one_.speak(writer_, 0.1), StreamHeard::kSecond);
  EXPECT_EQ(writer_.words(), "two write TARGET_POSE: sessions 11 and 22");
  EXPECT_FALSE(writer_.alone(now_at(1.0)));
  EXPECT_TRUE(writer_.alone(now_at(1.06)));
}

TEST_F(Writers, AReplacedOneThatLivesMakesTwo) {
  one_.speak(writer_, 0.0);
  other_.speak(writer_, 0.5);
  EXPECT_EQ(one_.speak(writer_, 0.6), StreamHeard::kWaits) << "it hung, say";
  EXPECT_EQ(other_.speak(writer_, 0.7), StreamHeard::kSecond);
}

TEST_F(Writers, TwoThatTakeTurnsWithPausesAreTwo) {
  one_.speak(writer_, 0.0);
  EXPECT_EQ(other_.speak(writer_, 0.4), StreamHeard::kAnew) << "as after a restart";
  EXPECT_EQ(one_.speak(writer_, 0.8), StreamHeard::kSecond);
  EXPECT_EQ(other_.speak(writer_, 1.2), StreamHeard::kSecond);
  EXPECT_FALSE(writer_.alone(now_at(1.3)));
  EXPECT_EQ(other_.speak(writer_, 2.3), StreamHeard::kAnew) << "alone again";
}

TEST_F(Writers, WhatWasUnderWayWhenAnotherTookOverIsNoSecondWord) {
  one_.speak(writer_, 0.0);
  other_.speak(writer_, 0.1);
  EXPECT_EQ(writer_.hear({11, 2, now_at(0.05)}, now_at(0.15)), StreamHeard::kTaken);
}

TEST_F(Writers, TwoWithOneSessionAreTwo) {
  one_.speak(writer_, 0.0);
  one_.speak(writer_, 0.1);
  EXPECT_EQ(writer_.hear({11, 1, now_at(0.15)}, now_at(0.15)), StreamHeard::kSecond);
  EXPECT_EQ(writer_.words(), "two write TARGET_POSE with one session: 11");
}

TEST_F(Writers, WhoWritesAloneAgainIsHeardAgain) {
  one_.speak(writer_, 0.0);
  other_.speak(writer_, 0.05);
  EXPECT_EQ(one_.speak(writer_, 0.1), StreamHeard::kSecond);
  EXPECT_EQ(one_.speak(writer_, 1.0), StreamHeard::kSecond);
  EXPECT_EQ(one_.speak(writer_, 1.1), StreamHeard::kAnew);
  EXPECT_EQ(one_.speak(writer_, 1.2), StreamHeard::kTaken);
  other_.speak(writer_, 1.25);
  EXPECT_EQ(one_.speak(writer_, 1.3), StreamHeard::kSecond) << "and two are two again";
}

TEST_F(Writers, OnceSettledTheWriterIsHeardAgain) {
  one_.speak(writer_, 0.0);
  other_.speak(writer_, 0.05);
  EXPECT_EQ(one_.speak(writer_, 2.0), StreamHeard::kSecond);
  writer_.settle();
  EXPECT_EQ(one_.speak(writer_, 2.1), StreamHeard::kTaken);
}

TEST_F(Writers, LateOnesAreDropped) {
  one_.speak(writer_, 0.0);
  one_.speak(writer_, 0.1);
  EXPECT_EQ(writer_.hear({11, 1, now_at(0.0)}, now_at(0.1)), StreamHeard::kLate);
}

TEST_F(Writers, AClockThatWentBackDoesNotKeepTheFloorForADeadOne) {
  one_.speak(writer_, 3600.0);
  EXPECT_EQ(other_.speak(writer_, 0.0), StreamHeard::kWaits);
  EXPECT_EQ(other_.speak(writer_, 0.31), StreamHeard::kAnew);
}

}  // namespace
}  // namespace markservo::motion
