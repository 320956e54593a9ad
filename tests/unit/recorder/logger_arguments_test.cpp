#include "services/recorder/logger/logger_arguments.hpp"

#include <gtest/gtest.h>
#include <lcm/lcm.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace markservo::recorder {
namespace {

// As liblcm takes it, whose subscriptions lcm-logger's are.
bool takes(const std::string& expression, const std::string& channel) {
  const std::unique_ptr<lcm_t, decltype(&lcm_destroy)> lcm(lcm_create("memq://"), &lcm_destroy);
  bool heard = false;
  const auto handler = [](const lcm_recv_buf_t* /*message*/, const char* /*channel*/, void* user) {
    *static_cast<bool*>(user) = true;
  };
  lcm_subscribe(lcm.get(), expression.c_str(), handler, &heard);
  lcm_publish(lcm.get(), channel.c_str(), "", 0);
  lcm_handle_timeout(lcm.get(), 0);
  return heard;
}

TEST(ReceiveBuffer, IsAskedForWhereTheUrlDoesNot) {
  EXPECT_EQ(with_receive_buffer("udpm://239.255.76.67:7667"), "udpm://239.255.76.67:7667?recv_buf_size=4194304");
  EXPECT_EQ(with_receive_buffer("udpm://?ttl=1"), "udpm://?ttl=1&recv_buf_size=4194304");
  EXPECT_EQ(with_receive_buffer("udpm://?recv_buf_size=9&ttl=1"), "udpm://?recv_buf_size=9&ttl=1");
  EXPECT_EQ(with_receive_buffer("tcpq://127.0.0.1:7700"), "tcpq://127.0.0.1:7700");
}

TEST(ReceiveBuffer, IsReadFromTheUrl) {
  EXPECT_EQ(asked_receive_buffer("udpm://?recv_buf_size=212992&ttl=0"), 212'992);
  EXPECT_EQ(asked_receive_buffer("tcpq://"), std::nullopt);
  EXPECT_EQ(asked_receive_buffer("udpm://?recv_buf_size=large"), std::nullopt);
}

TEST(MulticastGroup, IsTheUrlsOrLiblcmsOwn) {
  EXPECT_EQ(multicast_group("udpm://239.1.2.3:7667?ttl=0"), "239.1.2.3");
  EXPECT_EQ(multicast_group("udpm://239.1.2.3"), "239.1.2.3");
  EXPECT_EQ(multicast_group("udpm://"), "239.255.76.67");
  EXPECT_EQ(multicast_group("udpm://?ttl=0"), "239.255.76.67");
  EXPECT_EQ(multicast_group("tcpq://127.0.0.1:7700"), std::nullopt);
}

TEST(ChannelExpression, TakesAllButWhatRecordersSayOfThemselves) {
  const std::string all = channel_expression(true, "");
  EXPECT_TRUE(takes(all, "STEREO_FRAME"));
  EXPECT_TRUE(takes(all, "left/JOINT_STATE"));
  EXPECT_TRUE(takes(all, "anything of others"));
  EXPECT_TRUE(takes(all, "RECORDER_STATUS_OF_OTHERS"));
  for (const bool frames : {true, false}) {
    EXPECT_FALSE(takes(channel_expression(frames, ""), "RECORDER_STATUS"));
    EXPECT_FALSE(takes(channel_expression(frames, ""), "left/RECORDER_STATUS"));
    EXPECT_FALSE(takes(channel_expression(frames, "left"), "left/RECORDER_STATUS"));
  }
}

TEST(ChannelExpression, TakesOneRobotsChannels) {
  const std::string expression = channel_expression(true, "left");
  EXPECT_TRUE(takes(expression, "left/STEREO_FRAME"));
  EXPECT_TRUE(takes(expression, "left/JOINT_STATE"));
  EXPECT_FALSE(takes(expression, "right/JOINT_STATE"));
  EXPECT_FALSE(takes(expression, "JOINT_STATE"));
}

TEST(ChannelExpression, LeavesFramesOut) {
  const std::string all = channel_expression(false, "");
  EXPECT_FALSE(takes(all, "STEREO_FRAME"));
  EXPECT_FALSE(takes(all, "left/STEREO_FRAME"));
  EXPECT_TRUE(takes(all, "STEREO_FRAME_OF_OTHERS"));
  EXPECT_TRUE(takes(all, "left/JOINT_STATE"));
  const std::string left = channel_expression(false, "left");
  EXPECT_FALSE(takes(left, "left/STEREO_FRAME"));
  EXPECT_TRUE(takes(left, "left/JOINT_STATE"));
  EXPECT_FALSE(takes(left, "right/JOINT_STATE"));
}

TEST(UnwrittenMegabytes, AreAQuarterOfTheMemoryWithinLimits) {
  EXPECT_EQ(unwritten_megabytes(std::int64_t{4096} * 700), 700);
  EXPECT_EQ(unwritten_megabytes(0), 100);
  EXPECT_EQ(unwritten_megabytes(std::int64_t{4096} * 1'000'000), 1000);
}

TEST(LoggerArguments, SplitOnlyWhereAskedTo) {
  RecordingPlan plan;
  plan.lcm_url = "udpm://?ttl=0";
  std::vector<std::string> arguments = logger_arguments(plan, std::int64_t{4096} * 700, "/logs/a b/log.lcm");
  EXPECT_EQ(arguments,
            (std::vector<std::string>{"--lcm-url=udpm://?ttl=0", "--channel=" + channel_expression(true, ""),
                                      "--max-unwritten-mb=700", "--flush-interval=250", "/logs/a b/log.lcm"}));
  plan.split_mb = 500;
  arguments = logger_arguments(plan, std::int64_t{4096} * 700, "/logs/a b/log.lcm");
  EXPECT_EQ(std::count(arguments.begin(), arguments.end(), "-i"), 1);
  EXPECT_EQ(std::count(arguments.begin(), arguments.end(), "--split-mb=500"), 1);
  EXPECT_EQ(arguments.back(), "/logs/a b/log.lcm");
}

}  // namespace
}  // namespace markservo::recorder
