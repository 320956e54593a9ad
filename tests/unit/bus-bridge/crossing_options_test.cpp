#include "services/bus-bridge/crossing_options.hpp"

#include <gtest/gtest.h>

#include "common/bus/bus_url.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::bus_bridge {
namespace {

constexpr char kLink[] = "udpm://239.255.76.68:7668?ttl=1";

Crossing one_channel() {
  Crossing crossing;
  crossing.link_url = kLink;
  crossing.send = {"TARGET_POSE"};
  return crossing;
}

std::string why_refused(const Crossing& crossing, const std::string& local_url = bus::kDefaultUrl) {
  try {
    check(crossing);
    check_beside(crossing, local_url);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "";
}

TEST(Crossing, OneChannelOneWayWillDo) {
  EXPECT_EQ(why_refused(one_channel()), "");
  Crossing back;
  back.link_url = kLink;
  back.receive = {"JOINT_COMMAND"};
  EXPECT_EQ(why_refused(back), "");
}

TEST(Crossing, TheSameChannelMayCrossBothWays) {
  Crossing crossing = one_channel();
  crossing.send = crossing.receive = {"STOP"};
  EXPECT_EQ(why_refused(crossing), "");
}

TEST(Crossing, OnlyWhatManyMayWriteMayCrossBothWays) {
  Crossing crossing = one_channel();
  crossing.receive = crossing.send;
  EXPECT_NE(why_refused(crossing).find("both name TARGET_POSE, which one alone may write; allowed: one of them"),
            std::string::npos);
  crossing.send = crossing.receive = {"UNLISTED"};
  EXPECT_EQ(why_refused(crossing), "") << "what the table does not have is its writers' matter";
}

TEST(Crossing, WhatIsTooLargeForALinkIsToldBeforeItIsLost) {
  Crossing crossing = one_channel();
  crossing.send = {"MARK_DETECTION"};
  EXPECT_NE(why_refused(crossing).find("names MARK_DETECTION, whose messages may exceed 9000 bytes"),
            std::string::npos);
  crossing.largest = 65000;
  EXPECT_EQ(why_refused(crossing), "") << "who knows his link may say so";
}

TEST(Crossing, ALinkMustBeNamedAndLive) {
  Crossing crossing = one_channel();
  for (const char* url : {"", "memq://", "file://link.lcm?mode=w", "tcpq://"}) {
    crossing.link_url = url;
    EXPECT_NE(why_refused(crossing).find("--link-url is '" + std::string(url) + "'; allowed: udpm://"),
              std::string::npos)
        << url;
  }
}

TEST(Crossing, ALogIsNoBusToBridge) {
  EXPECT_NE(why_refused(one_channel(), "file://log.lcm?speed=0").find("--lcm-url"), std::string::npos);
}

TEST(Crossing, ALinkOnTheHostsOwnPortWouldBeTheSameBus) {
  Crossing crossing = one_channel();
  for (const char* url : {"udpm://239.255.76.68:7667?ttl=1", "udpm://?ttl=1", "udpm://239.255.76.68?ttl=1"}) {
    crossing.link_url = url;
    EXPECT_NE(why_refused(crossing).find("another port"), std::string::npos) << url;
  }
}

TEST(Crossing, WithoutAChannelThereIsNothingToDo) {
  Crossing crossing = one_channel();
  crossing.send.clear();
  EXPECT_NE(why_refused(crossing).find("name no channel"), std::string::npos);
}

TEST(Crossing, ChannelsAreNamedOneByOne) {
  for (const char* name : {".*", "target_pose", "", "r1/TARGET_POSE", "A B"}) {
    Crossing crossing = one_channel();
    crossing.receive = {name};
    EXPECT_NE(why_refused(crossing).find("--receive names '" + std::string(name) + "'"), std::string::npos) << name;
  }
  Crossing crossing = one_channel();
  crossing.send = {"STOP", "STOP"};
  EXPECT_NE(why_refused(crossing).find("--send names STOP twice"), std::string::npos);
}

}  // namespace
}  // namespace markservo::bus_bridge
