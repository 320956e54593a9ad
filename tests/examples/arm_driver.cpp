#include "tests/examples/arm_driver.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/messages/motion_messages.hpp"
#include "common/motion/command_lead.hpp"

namespace markservo::example {
namespace {

constexpr std::chrono::milliseconds kPeriod(10);
constexpr double kPeriod_s = 0.01;
constexpr double kServoSpeed = 2.0;  // rad/s
constexpr double kJointLimit = 2.0;  // rad, to each side

}  // namespace

void ArmDriver::start(bus::Bus& bus) {
  joint_states_.emplace(bus.advertise(channels::kJointState));
  stop_states_.emplace(bus.advertise(channels::kStopState));
  gate_.emplace(channels::kJointCommand.name, bus.session());
  bus.on_each(channels::kJointCommand, [this](const JointCommand& command) { on_command(command); });
  bus.on_each(channels::kStop, [this](const StopRequest& request) { on_stop(request); });
  bus.every(kPeriod, [this] { tick(); });
}

void ArmDriver::on_command(const JointCommand& command) {
  if (command.num_joints != kJoints) {
    messages::drop("num_joints is " + std::to_string(command.num_joints) + "; allowed: " + std::to_string(kJoints));
  }
  // What a command asks for may be any number; what the arm can do is the driver's to know.
  Joints speed{};
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    speed[joint] = std::min(command.speed_limit[joint], kServoSpeed);
  const std::vector<double> shaft(position_.begin(), position_.end());
  const std::vector<double> speeds(speed.begin(), speed.end());
  motion::OfferedCommand offered{messages::command_stamp(command), command.joint_session};
  offered.leads = motion::leading_joint(command.position, speeds, shaft).has_value();
  offered.jumps = path_.jumping_joint(command.position, speeds, shaft, offered.stamp.utime).has_value();
  const motion::CommandVerdict verdict = gate_->hear(offered, now_(), latch_.latched());
  if (verdict == motion::CommandVerdict::kTwoWriters) {
    latch_.latch(gate_->two_writers(), now_());
    stand();
    tell_stop_state();
  }
  if (verdict == motion::CommandVerdict::kLatched) return;  // commands go on while the arm is stopped
  if (verdict != motion::CommandVerdict::kObeyed) messages::drop(std::string("command ") + describe(verdict));
  path_.follow(command.position, offered.stamp.utime);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    wanted_[joint] = std::clamp(command.position[joint], -kJointLimit, kJointLimit);
  }
  speed_limit_ = speed;
}

void ArmDriver::stand() {
  wanted_ = position_;
  path_.forget();
}

void ArmDriver::on_stop(const StopRequest& request) {
  const motion::StopRequestStamp stamp{{request.session, request.request_id, request.utime},
                                       request.kind == StopRequest::RESET,
                                       request.source + ": " + request.reason};
  const motion::StopHeard heard = latch_.hear(stamp, now_(), gate_->obstacle(now_()));
  if (heard == motion::StopHeard::kStale) messages::drop("RESET refused: " + latch_.why_stale(stamp, now_()));
  if (heard == motion::StopHeard::kLatched) stand();
  if (heard == motion::StopHeard::kReleased) gate_->release(now_());
  tell_stop_state();
}

void ArmDriver::tick() {
  if (gate_->silent(now_())) stand();
  bool moving = false;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const double way = speed_limit_[joint] * kPeriod_s;
    const double step = std::clamp(wanted_[joint] - position_[joint], -way, way);
    position_[joint] += step;
    moving = moving || step != 0.0;
  }
  JointState state{};
  state.utime = now_();
  state.num_joints = kJoints;
  state.position.assign(position_.begin(), position_.end());
  state.speed.assign(kJoints, 0.0);
  state.moving = moving ? 1 : 0;
  joint_states_->publish(state);
  if (stop_state_timer_.due(state.utime)) tell_stop_state();
}

void ArmDriver::tell_stop_state() {
  StopState state{};
  state.utime = now_();
  state.device = "arm";
  state.latched = latch_.latched() ? 1 : 0;
  state.request_session = latch_.session();
  state.request_id = latch_.id();
  state.reason = latch_.reason();
  stop_states_->publish(state);
  stop_state_timer_.restart(state.utime);
}

}  // namespace markservo::example
