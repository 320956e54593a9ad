#include "services/stereo-camera/files/schedule.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::stereo_camera {
namespace {

TEST(TimeOfAPair, IsItsNumberOfPeriodsAfterTheStart) {
  EXPECT_EQ(time_of(kLogEpoch_us, 0, 15.0), 1'600'000'000'000'000);
  EXPECT_EQ(time_of(kLogEpoch_us, 1, 15.0), 1'600'000'000'066'667);
  EXPECT_EQ(time_of(kLogEpoch_us, 30, 15.0), 1'600'000'002'000'000);
}

TEST(TimeOfAPair, NeedsARate) {
  EXPECT_THROW(time_of(0, 1, 0.0), std::invalid_argument);
  EXPECT_THROW(time_of(0, 1, -1.0), std::invalid_argument);
}

TEST(Schedule, KeepsItsTimesWhileTheReaderKeepsUp) {
  Schedule schedule(1000, 10.0);
  EXPECT_EQ(schedule.due(0, 1000), 1000);
  EXPECT_EQ(schedule.due(1, 50'000), 101'000);
  EXPECT_EQ(schedule.due(2, 290'000), 201'000);
}

TEST(Schedule, MovesWhereTheReaderFallsBehindInsteadOfSendingABurst) {
  Schedule schedule(0, 10.0);
  EXPECT_EQ(schedule.due(1, 450'000), 450'000);
  EXPECT_EQ(schedule.due(2, 460'000), 550'000);
}

}  // namespace
}  // namespace markservo::stereo_camera
