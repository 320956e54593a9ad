#include "services/visual-servo/visual_servo_node.hpp"

#include <spdlog/spdlog.h>

#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/StopState.hpp>
#include <stdexcept>

#include "common/bus/number_options.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/visual-servo/servo_messages.hpp"

namespace markservo::visual_servo {
namespace {

const char* name_of(ServoState state) {
  switch (state) {
    case ServoState::kHold:
      return "hold";
    case ServoState::kPosture:
      return "posture";
    case ServoState::kServo:
      return "servo";
    case ServoState::kConverged:
      return "converged";
    case ServoState::kLost:
      return "lost";
    case ServoState::kUnreachable:
      return "unreachable";
    case ServoState::kStale:
      return "stale";
    case ServoState::kStopped:
      return "stopped";
  }
  return "unknown";
}

}  // namespace

void VisualServoNode::add_options(CLI::App& app) {
  SightParameters& sight = parameters_.sight;
  const bus::NumberOptions number(app);
  const auto count = [&app](const char* name, int& value, const char* what, int min, int max) {
    app.add_option(name, value, what)->check(CLI::Range(min, max))->capture_default_str();
  };
  app.add_option("--law", law_, "resolved-rate: the arm's Jacobian; paper: one joint per axis (paper eq. 6)")
      ->check(CLI::IsMember({"resolved-rate", "paper"}))
      ->capture_default_str();
  app.add_option("--stop-device", stop_device_, "The arm's name in STOP_STATE, one of robot.yaml's stop_devices")
      ->capture_default_str();
  number("--gain", sight.rate.gain, "Part of the remaining way per frame", 0.05, 1.0);
  number("--damping", sight.rate.damping, "Of the Jacobian's inverse, m", 0.001, 0.1);
  number("--joint-speed", sight.rate.joint_speed, "Limit of each joint while servoing, rad/s", 0.05, 10.0);
  number("--grip-speed", sight.rate.grip_speed, "Limit of the grip point, m/s; a goal may ask for less", 0.01, 2.0);
  number("--grip-acceleration", sight.rate.grip_acceleration, "Of the grip point, m/s^2", 0.1, 50.0);
  number("--posture-speed", parameters_.posture.joint_speed, "Limit of the joints towards a posture, rad/s", 0.05,
         10.0);
  number("--posture-acceleration", parameters_.posture.joint_acceleration, "Towards a posture, rad/s^2", 0.1, 100.0);
  number("--tolerance", sight.tolerance, "Converged within, m, for goals that state none", 0.0002, 0.05);
  number("--fine-tolerance", sight.fine_tolerance, "Aimed at while corrections help, m", 0.0001, 0.05);
  count("--fine-corrections", sight.fine_corrections, "Corrections after which the goal's tolerance will do", 0, 100);
  number("--back-off", sight.one_sided.back_off, "Against backlash, rad of each joint", 0.0, 0.1);
  number("--last-move", sight.one_sided.last_move, "Into the goal, rad: above a servo's deadband by a quarter", 0.0,
         0.05);
  count("--settled-frames", sight.settling.frames, "Averaged at rest", 1, 30);
  number("--settle-time", sight.settling.settle_time, "From the ramps' end to rest, s", 0.0, 2.0);
  count("--target-frames", parameters_.target.frames, "Averaged over a target that stands still, at most", 1, 1000);
  number("--pose-age", parameters_.pose_age, "Older pictures are not acted on, s", 0.02, 2.0);
  number("--joint-age", parameters_.joint_age, "Older joint states are not acted on, s", 0.02, 2.0);
  number("--goal-age", parameters_.goal_age, "A goal not repeated for longer is not followed, s", 0.25, 5.0);
  number("--hand-mismatch", parameters_.hand_mismatch, "Most between the hand mark and the joints' word, m", 0.001,
         1.0);
}

void VisualServoNode::configure(const std::string& robot_file) {
  const robot::RobotDescription description = robot::load_robot_description(robot_file);
  robot::require_stop_device(description, stop_device_, robot_file);
  parameters_.law = law_ == "paper" ? Law::kPaper : Law::kResolvedRate;
  try {
    machine_ = std::make_unique<ServoStateMachine>(description, parameters_);
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(robot_file + ": " + error.what());
  }
}

void VisualServoNode::start(bus::Bus& bus) {
  bus_ = &bus;
  commands_.emplace(bus.advertise(channels::kJointCommand));
  statuses_.emplace(bus.advertise(channels::kServoStatus));
  bus.on_each(channels::kStopState, [this](const StopState& stop) {
    if (stop.device == stop_device_) machine_->observe_stop(stop.latched != 0, stop.reason, state_);
  });
  bus.on_each(channels::kJointState, [this](const JointState& joints) {
    if (!machine_->observe(joint_sample(joints), state_)) throw std::invalid_argument("position is not finite");
  });
  bus.on_each(channels::kServoGoal, [this](const ServoGoal& goal) { machine_->observe(goal_of(goal), state_); });
  bus.on_latest(channels::kTargetPose, [this](const TargetPose& pose) { handle(pose); });
}

void VisualServoNode::handle(const TargetPose& pose) {
  const Output output = machine_->step(pose_sample(pose), state_);
  if (output.command) {
    JointCommand command = command_message(*output.command, pose);
    commands_->publish(command);
  }
  ServoStatus status = status_message(output.status, pose);
  statuses_->publish(status);
  tell(output.status);
}

void VisualServoNode::tell(const Status& status) {
  if (told_ == status.state) return;  // reasons may hold numbers that change with every frame
  told_ = status.state;
  bus_->set_state(name_of(status.state), status.reason);
  spdlog::info("{}{}{}", name_of(status.state), status.reason.empty() ? "" : ": ", status.reason);
}

}  // namespace markservo::visual_servo
