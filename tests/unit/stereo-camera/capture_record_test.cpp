#include "services/stereo-camera/capture_record.hpp"

#include <gtest/gtest.h>

namespace markservo::stereo_camera {
namespace {

TEST(CaptureRecord, TellsDropsOnceAndHowManyThereWereInAll) {
  CaptureRecord record;
  record.drop("half a picture", 2);
  EXPECT_EQ(record.next_health().reason, "2 pairs dropped in the last second, 2 since the start; last: half a picture");
  EXPECT_EQ(record.next_health().reason, "");
  record.drop("unpaired", 1);
  const CaptureRecord::Health health = record.next_health();
  EXPECT_EQ(health.state, "ready");
  EXPECT_EQ(health.reason, "1 pairs dropped in the last second, 3 since the start; last: unpaired");
}

TEST(CaptureRecord, WaitsUntilTheCamerasAreBack) {
  CaptureRecord record;
  EXPECT_TRUE(record.wait(true, "no such device"));
  record.lose(1);
  EXPECT_FALSE(record.wait(true, "")) << "it waits on";
  EXPECT_EQ(record.next_health().state, "waiting");
  EXPECT_EQ(record.next_health().reason, "no such device (lost 1 times)");
  EXPECT_TRUE(record.wait(false, ""));
  EXPECT_EQ(record.next_health().state, "ready");
}

}  // namespace
}  // namespace markservo::stereo_camera
