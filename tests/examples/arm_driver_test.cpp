// The example of services/DRIVERS.md keeps the rules that the page states.

#include "tests/examples/arm_driver.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::example {
namespace {

class Driver : public testing::Test {
 protected:
  Driver() : driver_([this] { return now_; }) {
    driver_.start(bus_);
    bus_.on_each(channels::kJointState, [this](const JointState& state) { joints_ = state; });
    bus_.on_each(channels::kStopState, [this](const StopState& state) { stop_ = state; });
  }

  void tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      now_ += 10'000;
      driver_.tick();
      bus::settle(bus_);
    }
  }
  void ask(std::int8_t kind, std::int64_t utime) {
    StopRequest request{};
    request.utime = utime;
    request.session = 7;
    request.request_id = ++request_id_;
    request.kind = kind;
    stops_.publish(request);
    bus::settle(bus_);
  }
  void release() { ask(StopRequest::RESET, now_); }
  void stop() { ask(StopRequest::STOP, 0); }
  // A command that answers what is measured now.
  void command(double yaw, std::int64_t made_for, std::int64_t age_us = 0) {
    JointCommand command{};
    command.utime = command.frame_utime = now_ - age_us;
    command.joint_session = made_for;
    command.num_joints = 3;
    command.position = {yaw, 0.0, 0.0};
    command.speed_limit = {1.0, 1.0, 1.0};
    commands_.publish(command);
    bus::settle(bus_);
  }
  // For so many ticks, as often as frames come.
  void command_on(double yaw, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      if (i % 3 == 0) command(yaw, bus_.session());
      tick();
    }
  }
  double yaw() const { return joints_.position.empty() ? 0.0 : joints_.position[0]; }

  std::int64_t now_ = 1'700'000'000'000'000;
  bus::Bus bus_{bus::memq_parameters("arm-driver")};
  ArmDriver driver_;
  bus::Publisher<JointCommand> commands_ = bus_.advertise(channels::kJointCommand);
  bus::Publisher<StopRequest> stops_ = bus_.advertise(channels::kStop);
  std::int64_t request_id_ = 0;
  JointState joints_{};
  StopState stop_{};
};

TEST_F(Driver, ComesUpStoppedAndSaysSoWithTheSessionOfItsJointStates) {
  tick(30);
  EXPECT_TRUE(stop_.latched);
  EXPECT_EQ(stop_.device, "arm");
  EXPECT_EQ(stop_.session, joints_.session);
  command_on(0.1, 30);
  EXPECT_EQ(yaw(), 0.0);
}

TEST_F(Driver, AFreshResetReleasesAndCommandsThenMove) {
  tick();
  release();
  EXPECT_FALSE(stop_.latched);
  EXPECT_EQ(stop_.request_id, request_id_);
  tick(30);
  EXPECT_EQ(yaw(), 0.0) << "a reset moves nothing by itself";
  command_on(0.1, 30);
  EXPECT_NEAR(yaw(), 0.1, 1e-9);
}

TEST_F(Driver, AnOldResetReleasesNothing) {
  tick();
  ask(StopRequest::RESET, now_ - 3'000'000);
  EXPECT_TRUE(stop_.latched);
  EXPECT_EQ(stop_.request_id, 0);
}

TEST_F(Driver, AStopOfAnyAgeHoldsAtOnce) {
  tick();
  release();
  tick();
  command_on(0.3, 10);
  stop();
  const double there = yaw();
  EXPECT_GT(there, 0.0);
  command_on(0.3, 30);
  EXPECT_EQ(yaw(), there);
}

TEST_F(Driver, WithoutCommandsItStandsAfterThreeTenthsOfASecond) {
  tick();
  release();
  tick();
  command(0.39, bus_.session());
  tick(31);
  const double there = yaw();
  EXPECT_LT(there, 0.39);
  tick(30);
  EXPECT_EQ(yaw(), there);
}

TEST_F(Driver, ObeysNothingMadeForAnotherArmOrTooOldOrTooFarAway) {
  tick();
  release();
  tick(40);
  command(0.1, 4711);
  command(0.1, bus_.session(), 310'000);
  command(2.0, bus_.session());
  tick(10);
  EXPECT_EQ(yaw(), 0.0);
  EXPECT_EQ(bus::refused(bus_, channels::kJointCommand.name), 3);
}

}  // namespace
}  // namespace markservo::example
