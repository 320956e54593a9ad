#include "services/stereo-camera/capture_record.hpp"

#include <gtest/gtest.h>

namespace markservo::stereo_camera {
namespace {

TEST(CaptureRecord, TellsDropsOnceAndHowManyThereWereInAll) {
  CaptureRecord record;
  record.drop("half a picture", 2);
  EXPECT_EQ(record.next_word().reason, "2 pairs dropped in the last second, 2 since the start; last: half a picture");
  EXPECT_EQ(record.next_word().reason, "");
  record.drop("unpaired", 1);
  const CaptureRecord::Word word = record.next_word();
  EXPECT_EQ(word.state, "ready");
  EXPECT_EQ(word.reason, "1 pairs dropped in the last second, 3 since the start; last: unpaired");
}

TEST(CaptureRecord, WaitsUntilTheCamerasAreBack) {
  CaptureRecord record;
  EXPECT_TRUE(record.wait(true, "no such device"));
  record.lose(1);
  EXPECT_FALSE(record.wait(true, "")) << "it waits on";
  EXPECT_EQ(record.next_word().state, "waiting");
  EXPECT_EQ(record.next_word().reason, "no such device (lost 1 times)");
  EXPECT_TRUE(record.wait(false, ""));
  EXPECT_EQ(record.next_word().state, "ready");
}

}  // namespace
}  // namespace markservo::stereo_camera
