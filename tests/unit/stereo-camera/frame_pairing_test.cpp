#include "services/stereo-camera/pairs/frame_pairing.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::stereo_camera {
namespace {

constexpr std::int64_t kPeriod_us = 33'334;
constexpr ClockReading kNow{50'000'000, 1'700'000'000'000'000};

TEST(FramePairing, TakesFramesUpToHalfAFrameApart) {
  EXPECT_EQ(pair_frames(1'000'000, 1'000'000 + kPeriod_us / 2, kPeriod_us), Pairing::kPair);
  EXPECT_EQ(pair_frames(1'000'000 + kPeriod_us / 2, 1'000'000, kPeriod_us), Pairing::kPair);
}

TEST(FramePairing, DropsTheOlderFrameBeyondThat) {
  EXPECT_EQ(pair_frames(1'000'000, 1'000'001 + kPeriod_us / 2, kPeriod_us), Pairing::kDropLeft);
  EXPECT_EQ(pair_frames(1'000'001 + kPeriod_us / 2, 1'000'000, kPeriod_us), Pairing::kDropRight);
}

TEST(FramePairing, NeedsAFramePeriod) {
  EXPECT_THROW(pair_frames(0, 0, 0), std::invalid_argument);
}

TEST(FrameTimeOfADriver, IsMovedFromTheMonotonicToTheRealtimeClock) {
  const FrameTime time = frame_time(kNow.monotonic_us - 12'000, kNow);
  EXPECT_TRUE(time.from_driver);
  EXPECT_EQ(time.utime, kNow.realtime_us - 12'000);
}

TEST(FrameTimeOfADriver, IsTakenAsItIsWhereItIsRealtime) {
  const FrameTime time = frame_time(kNow.realtime_us - 12'000, kNow);
  EXPECT_TRUE(time.from_driver);
  EXPECT_EQ(time.utime, kNow.realtime_us - 12'000);
}

TEST(FrameTimeOfADriver, IsTheTimeOfArrivalWhereTheDriverStatesNoneOrNonsense) {
  for (const std::int64_t stated : {std::int64_t{0}, std::int64_t{-5}, kNow.monotonic_us - 2 * kMaxFrameAge_us,
                                    kNow.monotonic_us + kMaxFrameAge_us}) {
    const FrameTime time = frame_time(stated, kNow);
    EXPECT_FALSE(time.from_driver) << stated;
    EXPECT_EQ(time.utime, kNow.realtime_us) << stated;
  }
}

}  // namespace
}  // namespace markservo::stereo_camera
