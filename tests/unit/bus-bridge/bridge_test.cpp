#include <gtest/gtest.h>

#include <markservo/JointState.hpp>
#include <markservo/StopRequest.hpp>
#include <vector>

#include "services/bus-bridge/bus_bridge_node.hpp"
#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::bus_bridge {
namespace {

Crossing crossing(std::vector<std::string> send, std::vector<std::string> receive) {
  Crossing result;
  result.send = std::move(send);
  result.receive = std::move(receive);
  return result;
}

JointState joints(std::int64_t utime) {
  JointState state{};
  state.utime = utime;
  return state;
}

StopRequest stop(std::int64_t id) {
  StopRequest request{};
  request.utime = 1;
  request.session = 5;
  request.request_id = id;
  request.source = "test";
  return request;
}

// Two hosts' buses would be in two processes; in one, both are memq buses that hear what they send themselves, as
// multicast does.
class BridgeTest : public ::testing::Test {
 protected:
  void settle() {
    for (int i = 0; i < 8; ++i) {
      local_.poll(std::chrono::milliseconds(0));
      link_.poll(std::chrono::milliseconds(0));
    }
  }

  template <class M>
  std::vector<M>& collect(bus::Bus& bus, const channels::Channel<M>& channel, std::vector<M>& messages) {
    bus.on_each(channel, [&messages](const M& message) { messages.push_back(message); });
    return messages;
  }

  static ChannelStatus counts(const bus::Bus& bus, const std::string& channel) {
    for (const ChannelStatus& one : bus.status().channels) {
      if (one.channel == channel) return one;
    }
    ADD_FAILURE() << channel << " is not counted";
    return {};
  }

  bus::Bus local_{bus::memq_parameters("local")};
  bus::Bus link_{bus::memq_parameters("link")};
};

TEST_F(BridgeTest, PassesANamedChannelWithItsSessionAndNumber) {
  const Bridge bridge(local_, link_, crossing({"JOINT_STATE"}, {}));
  std::vector<JointState> crossed;
  collect(link_, channels::kJointState, crossed);
  auto publisher = local_.advertise(channels::kJointState);
  for (std::int64_t utime = 1; utime <= 3; ++utime) {
    JointState state = joints(utime);
    publisher.publish(state);
  }
  settle();
  ASSERT_EQ(crossed.size(), 3U);
  EXPECT_EQ(crossed[2].utime, 3);
  EXPECT_EQ(crossed[2].seq, 3);
  EXPECT_EQ(crossed[2].session, local_.session());
}

TEST_F(BridgeTest, PassesWhatItReceivesFromTheLink) {
  const Bridge bridge(local_, link_, crossing({}, {"JOINT_STATE"}));
  std::vector<JointState> crossed;
  collect(local_, channels::kJointState, crossed);
  auto publisher = link_.advertise(channels::kJointState);
  JointState state = joints(1);
  publisher.publish(state);
  settle();
  EXPECT_EQ(crossed.size(), 1U);
}

TEST_F(BridgeTest, KeepsAllOtherChannelsWhereTheyAre) {
  const Bridge bridge(local_, link_, crossing({"JOINT_STATE"}, {}));
  std::vector<JointState> crossed;
  std::vector<JointState> back;
  const auto elsewhere = bus::made_up<JointState>("OTHER");
  collect(link_, elsewhere, crossed);
  collect(local_, channels::kJointState, back);
  auto other = local_.advertise(elsewhere);
  auto against = link_.advertise(channels::kJointState);
  JointState state = joints(1);
  other.publish(state);
  against.publish(state);
  settle();
  EXPECT_TRUE(crossed.empty());
  EXPECT_TRUE(back.empty());
}

TEST_F(BridgeTest, WhatCrossesBothWaysCrossesOnceAndComesToRest) {
  const Bridge bridge(local_, link_, crossing({"STOP"}, {"STOP"}));
  std::vector<StopRequest> here;
  std::vector<StopRequest> there;
  collect(local_, channels::kStop, here);
  collect(link_, channels::kStop, there);
  auto publisher = local_.advertise(channels::kStop);
  StopRequest request = stop(1);
  publisher.publish(request);
  settle();
  EXPECT_EQ(here.size(), 1U);
  EXPECT_EQ(there.size(), 1U);
  auto against = link_.advertise(channels::kStop);
  request = stop(2);
  against.publish(request);
  settle();
  EXPECT_EQ(here.size(), 2U);
  EXPECT_EQ(there.size(), 2U);
}

TEST_F(BridgeTest, TwoBridgesBetweenTheSameBusesComeToRestToo) {
  const Bridge one(local_, link_, crossing({"STOP"}, {"STOP"}));
  const Bridge another(local_, link_, crossing({"STOP"}, {"STOP"}));
  std::vector<StopRequest> here;
  collect(local_, channels::kStop, here);
  auto publisher = local_.advertise(channels::kStop);
  StopRequest request = stop(1);
  publisher.publish(request);
  for (int i = 0; i < 20; ++i) settle();
  EXPECT_LE(here.size(), 3U);
}

TEST_F(BridgeTest, AMessageTooLargeForALossyLinkIsRefusedAndCounted) {
  Crossing small = crossing({"STOP"}, {});
  small.largest = 100;
  const Bridge bridge(local_, link_, small);
  std::vector<StopRequest> crossed;
  collect(link_, channels::kStop, crossed);
  auto publisher = local_.advertise(channels::kStop);
  StopRequest request = stop(1);
  request.reason = std::string(100, 'x');
  publisher.publish(request);
  request = stop(2);
  publisher.publish(request);
  settle();
  ASSERT_EQ(crossed.size(), 1U);
  EXPECT_EQ(crossed[0].request_id, 2);
  EXPECT_EQ(counts(local_, "STOP").refused, 1);
}

TEST_F(BridgeTest, PassesBytesThatAreNoMessageAsTheyAre) {
  const Bridge bridge(local_, link_, crossing({"STOP"}, {}));
  std::string crossed;
  link_.on_raw("STOP", [&](const void* data, std::size_t size) {
    crossed.assign(static_cast<const char*>(data), size);
    return true;
  });
  local_.publish_raw("STOP", "rubbish", 7);
  settle();
  EXPECT_EQ(crossed, "rubbish");
}

TEST_F(BridgeTest, TheStatusCountsBothDirections) {
  const Bridge bridge(local_, link_, crossing({"STOP"}, {"STOP"}));
  local_.report_also(link_, "link:");
  auto publisher = local_.advertise(channels::kStop);
  StopRequest request = stop(1);
  publisher.publish(request);
  settle();
  EXPECT_EQ(counts(local_, "STOP").received, 1);
  EXPECT_EQ(counts(local_, "STOP").skipped, 0);
  // What it sent itself comes back from the link, and goes no further.
  EXPECT_EQ(counts(local_, "link:STOP").received, 1);
  EXPECT_EQ(counts(local_, "link:STOP").skipped, 1);
}

}  // namespace
}  // namespace markservo::bus_bridge
