// What SERVICE_STATUS says of a service that does not hear what it needs.

#include <chrono>
#include <cstdint>
#include <markservo/StopState.hpp>
#include <stdexcept>
#include <thread>

#include "common/time/clocks.hpp"
#include "tests/unit/bus/bus_fixture.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::bus {
namespace {

constexpr double kSoon = 0.05;  // s

class BusHealth : public BusTest {
 protected:
  BusHealth() : bus_(parameters()) {
    bus_.on_each(channels::kJointState, [](const JointState&) {});
    bus_.need(channels::kJointState, kSoon);
    bus_.set_state("ready");
  }

  void deliver(std::int64_t utime) {
    JointState state = joint_state(utime);
    state.session = 7;
    state.seq = ++seq_;
    const std::vector<std::uint8_t> bytes = test::encoded(state);
    bus_.publish_raw("JOINT_STATE", bytes.data(), bytes.size());
    settle(bus_);
  }
  static void let_it_grow_old() { std::this_thread::sleep_for(std::chrono::duration<double>(1.5 * kSoon)); }

  Bus bus_;
  std::int64_t seq_ = 0;
};

TEST_F(BusHealth, WaitsUntilItHearsWhatItNeeds) {
  EXPECT_EQ(bus_.status().state, "waiting");
  EXPECT_EQ(bus_.status().reason, "JOINT_STATE: not heard yet");
  EXPECT_EQ(bus_.state(), "ready") << "its own word";
  deliver(1);
  EXPECT_EQ(bus_.status().state, "ready");
  EXPECT_EQ(bus_.status().reason, "");
}

TEST_F(BusHealth, IsStaleWhenItStopsComing) {
  deliver(1);
  let_it_grow_old();
  EXPECT_EQ(bus_.status().state, "stale");
  bus_.set_state("servo", "2 mm to go");
  EXPECT_EQ(bus_.status().state, "stale");
  deliver(2);
  EXPECT_EQ(bus_.status().state, "servo") << "its own word again";
  EXPECT_EQ(bus_.status().reason, "2 mm to go");
}

TEST_F(BusHealth, ClocksApartCountAsNotHearing) {
  deliver(wall_clock_us() + 3'600'000'000);
  EXPECT_EQ(bus_.status().state, "waiting");
  EXPECT_EQ(bus_.status().reason,
            "JOINT_STATE: all refused: utime is 3600 s ahead of this host's clock; allowed: at most 20 ms");
  deliver(wall_clock_us());
  EXPECT_EQ(bus_.status().state, "ready");
}

TEST_F(BusHealth, WhatIsNotSubscribedCannotBeNeeded) {
  EXPECT_THROW(bus_.need(channels::kTargetPose), std::logic_error);
}

TEST_F(BusHealth, ChangeIsToldAtOnce) {
  BusParameters speaking = parameters();
  speaking.heartbeat = true;
  Bus bus(speaking);
  std::vector<std::string> told;
  bus.on_each(channels::kServiceStatus, [&](const ServiceStatus& status) { told.push_back(status.state); });
  bus.on_each(channels::kStopState, [](const StopState&) {});
  bus.need(channels::kStopState, kSoon);
  bus.set_state("ready");
  settle(bus);
  auto stops = bus.advertise(channels::kStopState);
  StopState stop{};
  stops.publish(stop);
  settle(bus);
  let_it_grow_old();
  settle(bus);
  EXPECT_EQ(told, (std::vector<std::string>{"waiting", "ready", "stale"}));
}

}  // namespace
}  // namespace markservo::bus
