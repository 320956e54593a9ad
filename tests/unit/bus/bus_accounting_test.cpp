// What went wrong on a channel is counted, named in SERVICE_STATUS, and never ends the service.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <stdexcept>

#include "tests/unit/bus/bus_fixture.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::bus {
namespace {

class BusAccounting : public BusTest {
 protected:
  BusAccounting() : bus_(parameters()) {
    bus_.on_each(channels::kJointState, [this](const JointState&) { ++handled_; });
  }

  // As another writer's: a publisher fills in the bus's own session.
  void deliver(JointState state, std::int64_t session, std::int64_t seq) {
    state.session = session;
    state.seq = seq;
    deliver_bytes(test::encoded(state));
  }
  void deliver_bytes(const std::vector<std::uint8_t>& bytes) {
    bus_.publish_raw("JOINT_STATE", bytes.data(), bytes.size());
  }
  ChannelStatus counted() {
    settle(bus_);
    return only_channel(bus_);
  }

  Bus bus_;
  int handled_ = 0;
};

TEST_F(BusAccounting, GapsInSeqAreLost) {
  for (const std::int64_t seq : {1, 2, 5, 6, 10, 11}) deliver(joint_state(seq), 7, seq);
  EXPECT_EQ(counted().lost, 5);
  EXPECT_EQ(handled_, 6);
}

TEST_F(BusAccounting, OneThatComesLateOrTwiceIsNoLoss) {
  for (const std::int64_t seq : {10, 9, 11, 9, 12}) deliver(joint_state(seq), 7, seq);
  EXPECT_EQ(counted().lost, 0);
}

TEST_F(BusAccounting, RestartOfTheWriterLosesNothing) {
  deliver(joint_state(1), 7, 41);
  deliver(joint_state(2), 8, 1);
  EXPECT_EQ(counted().lost, 0);
  EXPECT_FALSE(counted().second_writer);
}

TEST_F(BusAccounting, TwoWritersAtOnceAreNamed) {
  deliver(joint_state(1), 7, 1);
  deliver(joint_state(2), 8, 1);
  deliver(joint_state(3), 7, 2);
  EXPECT_TRUE(counted().second_writer);
}

TEST_F(BusAccounting, ManyMayWriteWhereTheTableSaysSo) {
  Bus bus(parameters());
  bus.on_each(channels::Channel<JointState>(channels::kStop), [](const JointState&) {});
  for (const std::int64_t session : {7, 8, 7, 8}) {
    JointState state = joint_state(1);
    state.session = session;
    state.seq = 3 * session;
    const std::vector<std::uint8_t> bytes = test::encoded(state);
    bus.publish_raw("STOP", bytes.data(), bytes.size());
  }
  settle(bus);
  EXPECT_EQ(only_channel(bus).received, 4);
  EXPECT_EQ(only_channel(bus).lost, 0);
  EXPECT_FALSE(only_channel(bus).second_writer);
}

TEST_F(BusAccounting, AnotherTypeOnTheChannelIsADecodeFailure) {
  StopState stop{};
  deliver_bytes(test::encoded(stop));
  EXPECT_EQ(counted().decode_failures, 1);
  EXPECT_EQ(handled_, 0);
}

TEST_F(BusAccounting, NoBytesAndHalfAMessageAreDecodeFailures) {
  JointState state = joint_state(1);
  std::vector<std::uint8_t> bytes = test::encoded(state);
  bytes.resize(bytes.size() / 2);
  deliver_bytes(bytes);
  deliver_bytes({});
  EXPECT_EQ(counted().decode_failures, 2);
}

TEST_F(BusAccounting, NotANumberIsRefused) {
  JointState state = joint_state(1);
  state.num_joints = 1;
  state.position = {NAN};
  state.speed = {0.0};
  deliver(state, 7, 1);
  EXPECT_EQ(counted().refused, 1);
  EXPECT_EQ(handled_, 0);
}

TEST_F(BusAccounting, ImpossibleTimesSessionsAndNumbersAreRefused) {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
  deliver(joint_state(1), 7, 1);
  std::int64_t refused = 0;
  for (const std::int64_t utime : {std::int64_t{-1}, kLeast, kMost}) deliver(joint_state(utime), 7, ++refused + 1);
  for (const std::int64_t session : {std::int64_t{0}, std::int64_t{-7}, kLeast})
    deliver(joint_state(1), session, ++refused + 1);
  for (const std::int64_t seq : {std::int64_t{-1}, kLeast, kMost}) {
    deliver(joint_state(1), 7, seq);
    ++refused;
  }
  EXPECT_EQ(counted().refused, refused);
  EXPECT_EQ(counted().lost, 0);
  EXPECT_EQ(handled_, 1);
}

TEST_F(BusAccounting, AnswerThatNamesAnotherTimeThanItsFramesIsRefused) {
  Bus bus(parameters());
  int handled = 0;
  bus.on_each(channels::kTargetPose, [&handled](const TargetPose&) { ++handled; });
  TargetPose pose{};
  pose.utime = pose.frame_utime = 1000;
  auto publisher = bus.advertise(channels::kTargetPose);
  publisher.publish(pose);
  pose.utime = 2000;
  EXPECT_THROW(publisher.publish(pose), std::invalid_argument);
  settle(bus);
  EXPECT_EQ(handled, 1);
}

TEST_F(BusAccounting, MessageFromTheFutureIsRefused) {
  const auto now =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  deliver(joint_state(now + 3'600'000'000), 7, 1);
  EXPECT_EQ(counted().refused, 1);
  deliver(joint_state(now), 7, 2);
  EXPECT_EQ(counted().refused, 1);
  EXPECT_EQ(handled_, 1);
}

TEST_F(BusAccounting, HandlerThatThrowsEndsNothing) {
  Bus bus(parameters());
  bus.on_each(channels::kJointState, [](const JointState&) { throw std::runtime_error("cannot"); });
  auto publisher = bus.advertise(channels::kJointState);
  auto state = joint_state(1);
  publisher.publish(state);
  settle(bus);
  EXPECT_EQ(only_channel(bus).refused, 1);
}

TEST_F(BusAccounting, AgeAndLatencyFollowTheNewestUtime) {
  Bus bus(parameters());
  bus.on_each(made_up<JointState>("FAST"), [](const JointState&) {});
  bus.on_each(made_up<JointState>("SLOW"), [](const JointState&) {});
  auto fast = bus.advertise(made_up<JointState>("FAST"));
  auto slow = bus.advertise(made_up<JointState>("SLOW"));
  auto early = joint_state(1'000'000);
  auto late = joint_state(1'500'000);
  fast.publish(late);
  slow.publish(early);
  settle(bus);
  EXPECT_DOUBLE_EQ(bus.status().channels[0].age, 0.0);
  EXPECT_DOUBLE_EQ(bus.status().channels[1].age, 0.5);
  EXPECT_DOUBLE_EQ(bus.status().channels[1].latency_p50, 0.5);
}

TEST_F(BusAccounting, ChannelNeverHeardHasNoAge) {
  EXPECT_DOUBLE_EQ(counted().age, -1.0);
}

TEST_F(BusAccounting, WriterThatRestartsEarlierBeginsANewTimeLine) {
  deliver(joint_state(50'000'000), 7, 1);
  for (const std::int64_t seq : {1, 2, 3}) deliver(joint_state(1'000'000 + seq), 8, seq);
  settle(bus_);
  EXPECT_EQ(bus_.newest_utime(), 1'000'003);
}

// A number or a time that lies spoils no figure for longer than it takes the next message to come.
TEST_F(BusAccounting, FiguresRecoverFromOneHostileMessage) {
  deliver(joint_state(50'000'000), 7, 10);
  deliver(joint_state(1), 7, std::int64_t{1} << 53);
  deliver(joint_state(50'010'000), 7, 11);
  EXPECT_EQ(counted().lost, 0);
  EXPECT_DOUBLE_EQ(counted().age, 0.0);
  EXPECT_LT(counted().latency_p99, 1.0);
  EXPECT_EQ(bus_.newest_utime(), 50'010'000);
  deliver(joint_state(50'020'000), 7, 13);
  deliver(joint_state(50'030'000), 7, 14);
  EXPECT_EQ(counted().lost, 1) << "what is lost afterwards is counted";
}

TEST_F(BusAccounting, StopOfAnUnknownTimeHasNoAge) {
  Bus bus(parameters());
  bus.on_each(channels::kJointState, [](const JointState&) {});
  bus.on_each(channels::kStop, [](const StopRequest&) {});
  auto joints = bus.advertise(channels::kJointState);
  auto stops = bus.advertise(channels::kStop);
  auto state = joint_state(1'700'000'000'000'000);
  joints.publish(state);
  StopRequest stop{};
  stop.session = 7;
  stops.publish(stop);
  settle(bus);
  EXPECT_EQ(bus.status().channels[1].received, 1);
  EXPECT_DOUBLE_EQ(bus.status().channels[1].age, -1.0);
  EXPECT_DOUBLE_EQ(bus.status().channels[1].latency_p99, 0.0);
}

TEST_F(BusAccounting, HeartbeatTellsStateOnceASecondAndOnChange) {
  BusParameters with_heartbeat = parameters();
  with_heartbeat.heartbeat = true;
  with_heartbeat.config_hash = 99;
  Bus bus(with_heartbeat);
  std::vector<ServiceStatus> seen;
  bus.on_each(channels::kServiceStatus, [&](const ServiceStatus& status) { seen.push_back(status); });
  bus.set_state("ready");
  bus.set_state("ready");
  bus.set_state("waiting", "no camera");
  settle(bus);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_EQ(seen[0].state, "ready");
  EXPECT_EQ(seen[1].state, "waiting");
  EXPECT_EQ(seen[1].reason, "no camera");
  EXPECT_EQ(seen[1].name, "test");
  EXPECT_EQ(seen[1].config_hash, 99);
  const auto before = seen.size();
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (seen.size() == before && std::chrono::steady_clock::now() < end) bus.poll(std::chrono::milliseconds(50));
  EXPECT_GT(seen.size(), before) << "no heartbeat";
}

}  // namespace
}  // namespace markservo::bus
