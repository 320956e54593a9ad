#include <poll.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <markservo/StopState.hpp>
#include <thread>

#include "tests/unit/bus/bus_fixture.hpp"

namespace markservo::bus {
namespace {

using BusDelivery = BusTest;

TEST_F(BusDelivery, LatestHandsOverOnlyTheNewestAndCountsTheRest) {
  Bus bus(parameters());
  std::vector<std::int64_t> seen;
  bus.on_latest(channels::kJointState, [&](const JointState& state) { seen.push_back(state.utime); });
  auto publisher = bus.advertise(channels::kJointState);
  for (std::int64_t utime = 1; utime <= 5; ++utime) {
    auto state = joint_state(utime);
    publisher.publish(state);
  }
  settle(bus);
  EXPECT_EQ(seen, std::vector<std::int64_t>{5});
  EXPECT_EQ(only_channel(bus).received, 5);
  EXPECT_EQ(only_channel(bus).skipped, 4);
}

TEST_F(BusDelivery, EachHandsOverAllInOrder) {
  Bus bus(parameters());
  std::vector<std::int64_t> seen;
  bus.on_each(channels::kJointState, [&](const JointState& state) { seen.push_back(state.utime); });
  auto publisher = bus.advertise(channels::kJointState);
  for (std::int64_t utime = 1; utime <= 5; ++utime) {
    auto state = joint_state(utime);
    publisher.publish(state);
  }
  settle(bus);
  EXPECT_EQ(seen, (std::vector<std::int64_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(only_channel(bus).skipped, 0);
}

TEST_F(BusDelivery, NoMessageCarriesAnythingOfTheOneBefore) {
  Bus bus(parameters());
  std::vector<std::vector<double>> seen;
  bus.on_each(channels::kJointState, [&](const JointState& state) { seen.push_back(state.position); });
  auto publisher = bus.advertise(channels::kJointState);
  const std::vector<std::vector<double>> sent{{1.0, 2.0, 3.0}, {}, {4.0}, {5.0, 6.0}};
  for (const std::vector<double>& position : sent) {
    auto state = joint_state(1);
    state.num_joints = static_cast<std::int32_t>(position.size());
    state.position = position;
    state.speed.assign(position.size(), 0.0);
    publisher.publish(state);
  }
  settle(bus);
  EXPECT_EQ(seen, sent);
}

TEST_F(BusDelivery, WaitingMessagesComeInTheOrderOfSubscription) {
  Bus bus(parameters());
  std::string order;
  bus.on_latest(channels::kStopState, [&](const StopState&) { order += "stop "; });
  bus.on_latest(channels::kJointState, [&](const JointState&) { order += "joints "; });
  auto joints = bus.advertise(channels::kJointState);
  auto stops = bus.advertise(channels::kStopState);
  auto state = joint_state(1);
  StopState stop{};
  joints.publish(state);
  stops.publish(stop);
  settle(bus);
  EXPECT_EQ(order, "stop joints ");
}

TEST_F(BusDelivery, RobotNamePrefixesAllChannels) {
  Bus bus(parameters("arm+1"));  // a name with a character that regular expressions know
  int seen = 0;
  bus.on_each(channels::kJointState, [&](const JointState&) { ++seen; });
  auto publisher = bus.advertise(channels::kJointState);
  auto state = joint_state(1);
  publisher.publish(state);
  settle(bus);
  EXPECT_EQ(seen, 1);
  EXPECT_EQ(only_channel(bus).channel, "arm+1/JOINT_STATE");
}

TEST_F(BusDelivery, PublisherFillsSessionAndSeq) {
  Bus bus(parameters());
  std::vector<JointState> seen;
  bus.on_each(channels::kJointState, [&](const JointState& state) { seen.push_back(state); });
  auto publisher = bus.advertise(channels::kJointState);
  auto state = joint_state(1);
  publisher.publish(state);
  publisher.publish(state);
  settle(bus);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].session, bus.session());
  EXPECT_EQ(seen[0].seq, 1);
  EXPECT_EQ(seen[1].seq, 2);
}

TEST_F(BusDelivery, MessageThatBreaksItsRulesIsNotSent) {
  Bus bus(parameters());
  int seen = 0;
  bus.on_each(channels::kJointState, [&](const JointState&) { ++seen; });
  auto publisher = bus.advertise(channels::kJointState);
  auto state = joint_state(1);
  state.num_joints = 1;  // but no position
  EXPECT_THROW(publisher.publish(state), std::invalid_argument);
  state.position = {NAN};
  state.speed = {0.0};
  EXPECT_THROW(publisher.publish(state), std::invalid_argument);
  settle(bus);
  EXPECT_EQ(seen, 0);
}

TEST_F(BusDelivery, NowIsTheNewestUtimeOfAnyChannel) {
  Bus bus(parameters());
  bus.on_each(channels::kJointState, [](const JointState&) {});
  auto publisher = bus.advertise(channels::kJointState);
  for (const std::int64_t utime : {3000, 9000, 6000}) {
    auto state = joint_state(utime);
    publisher.publish(state);
  }
  settle(bus);
  EXPECT_EQ(bus.newest_utime(), 9000);
}

TEST_F(BusDelivery, StopEndsTheLoop) {
  Bus bus(parameters());
  bus.stop();
  EXPECT_FALSE(bus.poll(std::chrono::milliseconds(0)));
}

TEST_F(BusDelivery, OfAllChannelsHandsOverEveryByteInOrder) {
  Bus bus(parameters());
  std::vector<std::string> channels;
  std::vector<std::size_t> sizes;
  bus.on_all({10, 10}, [&](const HeardBytes& message) {
    channels.push_back(message.channel);
    sizes.push_back(message.size);
  });
  auto publisher = bus.advertise(channels::kJointState);
  auto state = joint_state(1);
  publisher.publish(state);
  bus.publish_raw("OF_OTHERS", "abc", 3);
  settle(bus);
  EXPECT_EQ(channels, (std::vector<std::string>{"JOINT_STATE", "OF_OTHERS"}));
  EXPECT_EQ(sizes[1], 3U);
  EXPECT_TRUE(bus.status().channels.empty());
}

TEST_F(BusDelivery, OfAllChannelsHandsOverOneRobotsOnly) {
  Bus bus(parameters("r.1"));
  std::vector<std::string> channels;
  bus.on_all({10, 10}, [&](const HeardBytes& message) { channels.push_back(message.channel); });
  bus.publish_raw("JOINT_STATE", "abc", 3);
  settle(bus);
  EXPECT_EQ(channels, std::vector<std::string>{"r.1/JOINT_STATE"});
}

TEST_F(BusDelivery, OfAllChannelsHandsOverLargeOnesOnceAndAmongTheOthers) {
  Bus bus(parameters("r.1"));
  std::vector<std::string> channels;
  bus.on_all({10, 10}, [&](const HeardBytes& message) { channels.push_back(message.channel); });
  for (const char* channel : {"A", "STEREO_FRAME", "STEREO_FRAME_OF_OTHERS", "MARK_DETECTION", "B"}) {
    bus.publish_raw(channel, "abc", 3);
  }
  settle(bus);
  EXPECT_EQ(channels, (std::vector<std::string>{"r.1/A", "r.1/STEREO_FRAME", "r.1/STEREO_FRAME_OF_OTHERS",
                                                "r.1/MARK_DETECTION", "r.1/B"}));
}

TEST_F(BusDelivery, OfAllChannelsGivesOthersATurnAndStaysReadable) {
  Bus bus(parameters());
  int heard = 0;
  bus.on_all({10, 100}, [&](const HeardBytes& /*message*/) {
    ++heard;
    std::this_thread::sleep_for(std::chrono::milliseconds(6));
  });
  constexpr int kSent = 20;
  for (int i = 0; i < kSent; ++i) bus.publish_raw("A", "a", 1);
  for (int before = 0; heard < kSent; before = heard) {
    pollfd readable{bus.descriptor(), POLLIN, 0};
    ASSERT_EQ(::poll(&readable, 1, 0), 1) << "after " << heard;
    bus.poll(std::chrono::milliseconds(0));
    ASSERT_GT(heard, before);
    ASSERT_LE(heard, before + 3);  // 12 ms behind the first
  }
}

TEST_F(BusDelivery, OfOneChannelHandsOverTheNewestHoweverManyWait) {
  Bus bus(parameters());
  int raw = 0;
  std::vector<std::int64_t> seen;
  bus.on_raw("A", [&](const void* /*data*/, std::size_t /*size*/) {
    ++raw;
    std::this_thread::sleep_for(std::chrono::milliseconds(6));
    return true;
  });
  bus.on_latest(channels::kJointState, [&](const JointState& state) { seen.push_back(state.utime); });
  auto publisher = bus.advertise(channels::kJointState);
  for (std::int64_t utime = 1; utime <= 5; ++utime) {
    auto state = joint_state(utime);
    bus.publish_raw("A", "a", 1);
    publisher.publish(state);
  }
  bus.poll(std::chrono::milliseconds(0));
  EXPECT_EQ(raw, 5);
  EXPECT_EQ(seen, std::vector<std::int64_t>{5});
}

TEST_F(BusDelivery, TellsHowOftenItWasOpened) {
  Bus bus(parameters());
  bus.on_raw("A", [](const void* /*data*/, std::size_t /*size*/) { return true; });
  settle(bus);
  EXPECT_EQ(bus.openings(), 1);
}

TEST_F(BusDelivery, OfAllChannelsGoesOnAfterAHandlerThrew) {
  Bus bus(parameters());
  int heard = 0;
  bus.on_all({10, 10}, [&](const HeardBytes& /*message*/) {
    if (++heard == 1) throw std::runtime_error("no room");
  });
  bus.publish_raw("A", "1", 1);
  bus.publish_raw("B", "2", 1);
  settle(bus);
  EXPECT_EQ(heard, 2);
}

}  // namespace
}  // namespace markservo::bus
