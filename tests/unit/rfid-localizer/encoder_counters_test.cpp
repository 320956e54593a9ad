#include "services/rfid-localizer/encoder_counters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace markservo::rfid_localizer {
namespace {

constexpr std::int64_t kPeriod = 20'000;  // us

robot::BaseDescription base_of(int counter_bits) {
  robot::BaseDescription base;
  base.wheel_radius = 0.1;
  base.track = 0.3;
  base.ticks_per_turn = 1000;  // 0.628 mm a tick
  base.counter_bits = counter_bits;
  base.speed_max = 1.2;
  base.turn_rate_max = 3.0;
  return base;
}

// A driver that counts `left` and `right` ticks on from where it is, as counters of so many bits show it.
class Driver {
 public:
  explicit Driver(int counter_bits, std::int64_t left = 0, std::int64_t right = 0)
      : bits_(counter_bits), left_(left), right_(right) {}

  EncoderReading after(std::int64_t time, std::int64_t left, std::int64_t right) {
    utime_ += time;
    left_ += left;
    right_ += right;
    return {utime_, 5, counter(left_), counter(right_)};
  }

 private:
  std::int32_t counter(std::int64_t count) const {
    const std::int64_t period = std::int64_t{1} << bits_;
    const std::int64_t within = ((count % period) + period) % period;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(within));
  }

  int bits_;
  std::int64_t left_, right_;
  std::int64_t utime_ = 1'000'000;
};

TEST(EncoderCounters, TellNothingOfTheFirstReading) {
  EncoderCounters counters(base_of(16));
  EXPECT_FALSE(counters.motion(Driver(16).after(kPeriod, 5, 5)));
}

TEST(EncoderCounters, AreTheWayAndTheTurnOfADifferentialDrive) {
  const robot::BaseDescription base = base_of(16);
  EncoderCounters counters(base);
  Driver driver(16);
  counters.motion(driver.after(kPeriod, 0, 0));
  const auto motion = counters.motion(driver.after(kPeriod, 10, 20));
  ASSERT_TRUE(motion);
  const double tick = 2.0 * M_PI * 0.1 / 1000.0;
  EXPECT_NEAR(motion->way, 15.0 * tick, 1e-12);
  EXPECT_NEAR(motion->turn, 10.0 * tick / 0.3, 1e-12) << "the right wheel ahead turns to the left";
  EXPECT_NEAR(motion->time, 0.02, 1e-12);
  EXPECT_EQ(motion->unknown_way, 0.0);
}

TEST(EncoderCounters, WrapAroundForwardAndBackward) {
  for (const int bits : {16, 32}) {
    const double tick = base_of(bits).metres_per_tick();
    const std::int64_t last = (std::int64_t{1} << bits) - 1;
    for (const std::int64_t border : {std::int64_t{0}, last / 2, last}) {
      EncoderCounters counters(base_of(bits));
      Driver driver(bits, border - 3, border + 3);
      counters.motion(driver.after(kPeriod, 0, 0));
      const auto across = counters.motion(driver.after(kPeriod, 10, -10));
      ASSERT_TRUE(across);
      EXPECT_NEAR(across->way, 0.0, 1e-12) << bits;
      EXPECT_NEAR(across->turn, -20.0 * tick / 0.3, 1e-12) << bits << " from " << border;
      const auto back = counters.motion(driver.after(kPeriod, -10, 10));
      EXPECT_NEAR(back->turn, 20.0 * tick / 0.3, 1e-12) << bits << " from " << border;
    }
    EXPECT_EQ(EncoderCounters(base_of(bits)).jumps(), 0);
  }
}

TEST(EncoderCounters, WrapAroundAsSignedNumbersToo) {
  EncoderCounters counters(base_of(32));
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  counters.motion({1000, 5, most, -most - 1});
  const auto motion = counters.motion({21'000, 5, -most - 1, most});
  EXPECT_NEAR(motion->turn, -2.0 * base_of(32).metres_per_tick() / 0.3, 1e-12);
  EXPECT_NEAR(motion->way, 0.0, 1e-12);
}

TEST(EncoderCounters, RefuseAJumpAndTellHowFarTheRobotMayHaveGone) {
  EncoderCounters counters(base_of(16));
  Driver driver(16);
  counters.motion(driver.after(kPeriod, 0, 0));
  const auto jump = counters.motion(driver.after(kPeriod, 0, 2000));
  ASSERT_TRUE(jump);
  EXPECT_EQ(jump->way, 0.0);
  EXPECT_EQ(jump->turn, 0.0);
  EXPECT_NEAR(jump->unknown_way, 1.2 * 0.02, 1e-12);
  EXPECT_EQ(counters.jumps(), 1);
  const auto next = counters.motion(driver.after(kPeriod, 10, 10));
  EXPECT_NEAR(next->way, 10.0 * base_of(16).metres_per_tick(), 1e-12) << "the jump is past";
  EXPECT_EQ(next->unknown_way, 0.0);
  EXPECT_EQ(counters.jumps(), 1);
}

TEST(EncoderCounters, TakeTheFastestDriveForNoJump) {
  const double tick = base_of(16).metres_per_tick();
  const auto fastest = static_cast<std::int64_t>((1.2 + 0.5 * 0.3 * 3.0) * 0.02 / tick);
  EncoderCounters counters(base_of(16));
  Driver driver(16);
  counters.motion(driver.after(kPeriod, 0, 0));
  EXPECT_GT(counters.motion(driver.after(kPeriod, fastest, fastest))->way, 0.0);
  EXPECT_LT(counters.motion(driver.after(kPeriod, -fastest, -fastest))->way, 0.0);
  EXPECT_EQ(counters.jumps(), 0);
}

TEST(EncoderCounters, OfADriverThatRestartedSayNothingButAnUnknownWay) {
  EncoderCounters counters(base_of(16));
  counters.motion({1'000'000, 5, 100, 100});
  const auto motion = counters.motion({1'500'000, 6, 110, 110});
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->way, 0.0);
  EXPECT_NEAR(motion->unknown_way, 0.6, 1e-12);
  EXPECT_EQ(counters.jumps(), 0) << "a restart is no fault of the counters";
  EXPECT_NEAR(counters.motion({1'520'000, 6, 120, 120})->way, 10.0 * base_of(16).metres_per_tick(), 1e-12);
}

TEST(EncoderCounters, RefuseATimeThatDoesNotGoOnAndKeepWhatTheyHad) {
  EncoderCounters counters(base_of(16));
  counters.motion({1'000'000, 5, 100, 100});
  for (const std::int64_t utime : {1'000'000, 999'999, 0, -5}) {
    EXPECT_THROW(counters.motion({utime, 5, 500, 500}), std::invalid_argument) << utime;
  }
  EXPECT_NEAR(counters.motion({1'020'000, 5, 110, 110})->way, 10.0 * base_of(16).metres_per_tick(), 1e-12);
}

TEST(EncoderCounters, WhatWasForgottenIsNoMotion) {
  EncoderCounters counters(base_of(16));
  counters.motion({1'000'000, 5, 100, 100});
  counters.forget();
  EXPECT_FALSE(counters.motion({10, 5, 5000, 5000}));
}

TEST(EncoderCounters, OnceTheyForgotTellTurningAsFromTheStart) {
  EncoderCounters counters(base_of(16));
  counters.motion({1'000'000, 5, 100, 100});
  counters.motion({1'020'000, 5, 100, 110});  // against one end of the dead band
  counters.forget();
  EncoderCounters fresh(base_of(16));
  for (EncoderCounters* one : {&counters, &fresh}) one->motion({10, 5, 5000, 5000});
  const EncoderReading next{20'010, 5, 5000, 5010};
  EXPECT_EQ(counters.motion(next)->turning, fresh.motion(next)->turning);
}

// 65,536 ticks are 41 m: after a gap in which the wheels can have turned half as far, the ticks say nothing.
TEST(EncoderCounters, AfterAGapLongEnoughToWrapAroundUnseenSayNothingButAnUnknownWay) {
  const robot::BaseDescription base = base_of(16);
  const double half = 0.5 * 65536.0 * base.metres_per_tick();
  const auto gap = static_cast<std::int64_t>(1e6 * half / (1.2 + 0.5 * 0.3 * 3.0));
  for (const auto& [time, known] : {std::pair(gap - 100'000, true), std::pair(gap + 100'000, false)}) {
    EncoderCounters counters(base);
    Driver driver(16);
    counters.motion(driver.after(kPeriod, 0, 0));
    const auto motion = counters.motion(driver.after(time, 1000, 1000));
    ASSERT_TRUE(motion);
    EXPECT_EQ(motion->way > 0.0, known);
    EXPECT_EQ(motion->unknown_way > 0.0, !known);
  }
}

TEST(EncoderCounters, OfARobotWithoutABaseAreRefused) {
  EncoderCounters counters{robot::BaseDescription{}};
  try {
    counters.motion({1'000'000, 5, 100, 100});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("base"), std::string::npos) << error.what();
  }
}

// 2.1 mrad a tick: at 50 Hz a wheel that stops between two of them would pretend a turn of 6 degrees a second.
TEST(EncoderCounters, TheTicksJitterIsNoTurning) {
  EncoderCounters counters(base_of(16));
  Driver driver(16);
  counters.motion(driver.after(kPeriod, 0, 0));
  double turning = 0.0;
  double turn = 0.0;
  for (int i = 0; i < 200; ++i) {
    const bool even = i % 2 == 0;
    const auto motion = counters.motion(driver.after(kPeriod, even ? 10 : 11, even ? 11 : 10));
    turning += motion->turning;
    turn += std::abs(motion->turn);
  }
  EXPECT_NEAR(turning, 0.0, 1e-12);
  EXPECT_GT(turn, 0.4);
}

TEST(EncoderCounters, TurningToAndFroAddsUp) {
  EncoderCounters counters(base_of(16));
  Driver driver(16);
  counters.motion(driver.after(kPeriod, 0, 0));
  double turning = 0.0;
  double turn = 0.0;
  for (const std::int64_t direction : {1, -1}) {
    for (int i = 0; i < 50; ++i) {
      const auto motion = counters.motion(driver.after(kPeriod, -5 * direction, 5 * direction));
      turning += motion->turning;
      turn += motion->turn;
    }
  }
  const double tick = 2.0 * M_PI * 0.1 / 1000.0 / 0.3;
  EXPECT_NEAR(turn, 0.0, 1e-12);
  EXPECT_NEAR(turning, 2.0 * 500.0 * tick, 3.5 * tick) << "but for the dead band of the first way and of the reversal";
}

}  // namespace
}  // namespace markservo::rfid_localizer
