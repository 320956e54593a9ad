#include "services/base-navigator/base_navigator_node.hpp"

#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>
#include <stdexcept>

#include "common/bus/options.hpp"
#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/motion/notice.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/base-navigator/navigator_messages.hpp"
#include "services/base-navigator/navigator_options.hpp"

namespace markservo::base_navigator {
namespace {

using messages::drop;
using messages::stamp_of;

constexpr double kLongestWait_s = 0.1;  // since the newest pose, up to which the one that answers is waited for
constexpr std::chrono::milliseconds kWatch(100);
constexpr std::chrono::milliseconds kSilence(300);

}  // namespace

void BaseNavigatorNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.option("--stop-device", stop_device_, "The base's name in STOP_STATE, one of robot.yaml's stop_devices")
      .show_default();
  add_navigator_options(app, parameters_);
}

void BaseNavigatorNode::configure(const std::string& robot_file) {
  const robot::RobotDescription description = robot::load_robot_description(robot_file);
  robot::require_stop_device(description, "--stop-device", stop_device_, robot_file);
  require_consistent(parameters_);
  try {
    navigator_ = std::make_unique<Navigator>(description, parameters_);
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(robot_file + ": " + error.what());
  }
}

void BaseNavigatorNode::start(bus::Bus& bus) {
  bus_ = &bus;
  base_.emplace(stop_device_);
  commands_.emplace(bus.advertise(channels::kBaseCommand));
  statuses_.emplace(bus.advertise(channels::kBaseStatus));
  stops_.emplace(bus.advertise(channels::kStop));
  bus.on_each(channels::kStopState, [this](const StopState& stop) { on_stop(stop); });
  bus.on_each(channels::kBaseGoal, [this](const BaseGoal& goal) { on_goal(goal); });
  bus.on_each(channels::kSonarScan, [this](const SonarScan& scan) { on_scan(scan); });
  bus.on_each(channels::kWheelOdometry, [this](const WheelOdometry& odometry) { on_odometry(odometry); });
  bus.on_each(channels::kRobotPose, [this](const RobotPose& pose) { on_pose(pose); });
  bus.need(channels::kWheelOdometry);
  bus.need(channels::kRobotPose);
  bus.need(channels::kSonarScan);
  bus.need(channels::kStopState);
  bus.every(kWatch, [this] { watch_for_odometry(); });
  bus.set_state("stale", "no WHEEL_ODOMETRY yet");
}

void BaseNavigatorNode::on_stop(const StopState& stop) {
  if (stop.device != stop_device_) return;
  const motion::ReportHeard heard = base_->hear_stop_state(stamp_of(stop), stop.latched != 0, stop.reason);
  if (heard == motion::ReportHeard::kReplaced) begin_anew("the base began anew");
  if (heard == motion::ReportHeard::kAnew) begin_anew("the clock of STOP_STATE was set back");
  const std::string why = motion::why_dropped(heard);
  if (why.empty()) navigator_->observe_stop(*base_->latched(), base_->stop_reason(), state_);
  after_input();
  drop(why);
}

void BaseNavigatorNode::on_goal(const BaseGoal& goal) {
  const motion::GoalHeard heard = navigator_->observe(goal_of(goal), state_);
  if (heard == motion::GoalHeard::kContested) base_->raise(state_.goal.inbox().two());
  after_input();
  if (heard == motion::GoalHeard::kNew) drop(state_.goal.refusal());
  if (heard == motion::GoalHeard::kBeyond) {
    drop(state_.goal.inbox().why_beyond({goal.session, goal.goal_id, goal.utime}));
  }
}

void BaseNavigatorNode::begin_anew(const std::string& why) {
  navigator_->begin_anew(why, state_);
  pacing_ = AnswerPacing();
}

motion::ReportHeard BaseNavigatorNode::hear_report(const char* channel, const motion::Stamp& stamp) {
  const motion::ReportHeard heard = base_->hear_report(channel, stamp);
  if (heard == motion::ReportHeard::kAnew) begin_anew(std::string("the clock of ") + channel + " was set back");
  after_input();
  drop(motion::why_dropped(heard));
  return heard;
}

void BaseNavigatorNode::on_scan(const SonarScan& scan) {
  hear_report(channels::kSonarScan.name, stamp_of(scan));
  drop(navigator_->observe(scan_sample(scan), state_));
}

void BaseNavigatorNode::on_odometry(const WheelOdometry& odometry) {
  hear_report(channels::kWheelOdometry.name, stamp_of(odometry));
  heard_odometry_ = std::chrono::steady_clock::now();
  if (const auto overdue = pacing_.observe_odometry(identity(odometry))) answer(*overdue);
  const std::string problem = navigator_->observe(odometry_sample(odometry), state_);
  if (const auto due = pacing_.due(kLongestWait_s)) answer(*due);
  drop(problem);
}

void BaseNavigatorNode::on_pose(const RobotPose& pose) {
  const motion::StreamHeard heard = base_->hear_stream(channels::kRobotPose.name, stamp_of(pose));
  after_input();
  drop(motion::why_dropped(heard));
  pacing_.observe_pose(identity(pose));
  navigator_->observe(pose_sample(pose), state_);
  if (const auto due = pacing_.due(kLongestWait_s)) answer(*due);
}

// What two that claim to be one lead to.
void BaseNavigatorNode::after_input() {
  state_.enable.observe_conflict(base_->conflict());
  if (const auto wish = base_->stop_due()) {
    StopRequest stop = messages::stop_request(*wish, base_->now(), bus_->session(), "base-navigator");
    stops_->publish(stop);
  }
}

// The status first: who waits for the command of an odometry then has both.
void BaseNavigatorNode::answer(const OdometryId& odometry) {
  const Output output = navigator_->step(state_);
  BaseStatus status = status_message(output.status, odometry);
  statuses_->publish(status);
  BaseCommand command = command_message(output.command, odometry);
  commands_->publish(command);
  tell(output.status.state, output.status.reason);
}

// Nothing can be said of a base that does not tell where its wheels are; no command stops it, by its own watchdog.
void BaseNavigatorNode::watch_for_odometry() {
  if (!heard_odometry_ || std::chrono::steady_clock::now() - *heard_odometry_ < kSilence) return;
  tell(DriveState::kStale, "no WHEEL_ODOMETRY for 0.3 s");
}

void BaseNavigatorNode::tell(DriveState state, const std::string& reason) {
  const std::string others = motion::notice(*base_, state_.goal.inbox(), parameters_.trust.goal_age);
  if (told_ && told_->state == state && told_->notice == others) return;
  told_ = Told{state, others};
  std::string words = reason;
  if (!others.empty() && others != reason) words += (reason.empty() ? "" : "; ") + others;
  bus_->set_state(name_of(state), words);
  logging::info("{}{}{}", name_of(state), words.empty() ? "" : ": ", words);
}

}  // namespace markservo::base_navigator
