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

// What a person does about it depends on it.
class JpegIsChosen : public ::testing::Test {
 protected:
  static constexpr std::int64_t kEnough = 4'194'304;  // bytes
  static constexpr std::int64_t kSmall = 212'992;     // as Debian grants by default
};

TEST_F(JpegIsChosen, NotWhereAddressAndKernelGiveEnough) {
  EXPECT_EQ(raw_frames_obstacle("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304", kEnough), "");
  EXPECT_EQ(raw_frames_obstacle("udpm://?recv_buf_size=2000000", kEnough), "");
  EXPECT_EQ(raw_frames_obstacle("memq://", kSmall), "");
}

TEST_F(JpegIsChosen, BecauseTheAddressAsksForNothing) {
  EXPECT_EQ(raw_frames_obstacle("udpm://239.255.76.67:7667?ttl=1", kEnough),
            "the bus's address asks for no receive buffer; raw frames need 2000000: use --lcm-url "
            "'udpm://239.255.76.67:7667?ttl=1&recv_buf_size=4194304'");
  EXPECT_NE(raw_frames_obstacle("udpm://239.255.76.67:7667", kEnough).find("7667?recv_buf_size=4194304'"),
            std::string::npos);
  // Another parameter whose name ends alike is none.
  EXPECT_NE(raw_frames_obstacle("udpm://?xrecv_buf_size=4194304", kEnough).find("asks for no"), std::string::npos);
}

TEST_F(JpegIsChosen, BecauseTheAddressAsksForLittle) {
  EXPECT_EQ(raw_frames_obstacle("udpm://239.255.76.67:7667?recv_buf_size=65536&ttl=0", kEnough),
            "the bus's address asks for a receive buffer of 65536 bytes; raw frames need 2000000: use --lcm-url "
            "'udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304'");
}

TEST_F(JpegIsChosen, BecauseTheKernelGrantsLittle) {
  EXPECT_EQ(raw_frames_obstacle("udpm://239.255.76.67:7667?recv_buf_size=4194304", kSmall),
            "the kernel grants receive buffers of at most 212992 bytes (net.core.rmem_max); raw frames need 2000000: "
            "run: sysctl -w net.core.rmem_max=4194304");
}

TEST_F(JpegIsChosen, ForBothReasonsAtOnce) {
  const std::string both = raw_frames_obstacle("udpm://239.255.76.67:7667", kSmall);
  EXPECT_NE(both.find("asks for no receive buffer, and the kernel grants"), std::string::npos) << both;
  EXPECT_NE(both.find("', and run: sysctl -w"), std::string::npos) << both;
}

TEST_F(JpegIsChosen, WithOneLineThatSaysSo) {
  EXPECT_EQ(jpeg_notice("the reason"), "frames go as JPEG: the reason");
}

}  // namespace
}  // namespace markservo::bus
