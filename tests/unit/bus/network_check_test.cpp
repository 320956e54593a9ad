#include "common/bus/network_check.hpp"

#include <gtest/gtest.h>

namespace markservo::bus {
namespace {

TEST(NetworkCheck, RawFramesFitThroughMemoryAndFiles) {
  EXPECT_TRUE(raw_frames_fit("memq://"));
  EXPECT_TRUE(raw_frames_fit("file:///tmp/x.lcm?mode=w"));
}

TEST(NetworkCheck, RawFramesDoNotFitThroughASmallReceiveBuffer) {
  EXPECT_FALSE(raw_frames_fit("udpm://239.255.76.67:7667?ttl=0"));
  EXPECT_FALSE(raw_frames_fit("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=212992"));
}

TEST(NetworkCheck, TheKernelTellsWhatItGrants) {
  const auto small = granted_receive_buffer(65536);
  ASSERT_TRUE(small);
  EXPECT_EQ(*small, 65536);
  // No kernel grants this much; it clamps without a word.
  EXPECT_LT(*granted_receive_buffer(1'000'000'000), 1'000'000'000);
}

TEST(NetworkCheck, RawFramesFitOnlyIfTheKernelGrantsTheBuffer) {
  const bool granted = *granted_receive_buffer(4194304) >= kReceiveBufferForRawFrames;
  EXPECT_EQ(raw_frames_fit("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304"), granted);
}

}  // namespace
}  // namespace markservo::bus
