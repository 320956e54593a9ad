#pragma once

// The worked example of services/DRIVERS.md: the driver of an arm, in as few lines as keep every rule. Its arm is the
// simplest that can be: servos that follow at the speed they are told and report where they were sent.

#include <array>
#include <cstdint>
#include <functional>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/repeat_timer.hpp"
#include "common/bus/service.hpp"
#include "common/motion/command_gate.hpp"
#include "common/motion/command_path.hpp"
#include "common/motion/stop_latch.hpp"
#include "common/time/clocks.hpp"

namespace markservo::example {

// JOINT_COMMAND and STOP in; JOINT_STATE at 100 Hz and STOP_STATE on every change and at 5 Hz out, with one session.
class ArmDriver : public bus::Service {
 public:
  // `now`: us, the clock that all is stamped with.
  explicit ArmDriver(std::function<std::int64_t()> now = wall_clock_us) : now_(std::move(now)) {}

  void add_options(CLI::App& /*app*/) override {}
  void configure(const std::string& /*robot_file*/) override {}
  void start(bus::Bus& bus) override;

  // What is done every 10 ms: move, report.
  void tick();

 private:
  static constexpr int kJoints = 3;
  using Joints = std::array<double, kJoints>;

  void on_command(const JointCommand& command);
  void stand();
  void on_stop(const StopRequest& request);
  void tell_stop_state();

  std::function<std::int64_t()> now_;
  motion::StopLatch latch_{"the arm's clock"};
  std::optional<motion::CommandGate> gate_;
  motion::CommandPath path_;
  std::optional<bus::Publisher<JointState>> joint_states_;
  std::optional<bus::Publisher<StopState>> stop_states_;
  bus::RepeatTimer stop_state_timer_{bus::kStateRepeat_us};

  // The device. A real one's bytes go over a wire.
  Joints position_{};     // rad
  Joints wanted_{};       // rad
  Joints speed_limit_{};  // rad/s
};

}  // namespace markservo::example
