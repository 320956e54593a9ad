#include "services/base-navigator/base_navigator_node.hpp"

#include <spdlog/spdlog.h>

#include <stdexcept>

#include "common/bus/number_options.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/motion/notice.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/base-navigator/navigator_messages.hpp"

namespace markservo::base_navigator {
namespace {

using messages::drop;
using messages::stamp_of;

constexpr double kLongestWait_s = 0.1;  // since the newest pose, up to which the one that answers is waited for
constexpr std::chrono::milliseconds kWatch(100);
constexpr std::chrono::milliseconds kSilence(300);

}  // namespace

void BaseNavigatorNode::add_options(CLI::App& app) {
  app.add_option("--stop-device", stop_device_, "The base's name in STOP_STATE, one of robot.yaml's stop_devices")
      ->capture_default_str();
  const bus::NumberOptions number(app);
  add_motion_options(app);
  ArrivalParameters& arrival = parameters_.manoeuvre.arrival;
  number("--tolerance", arrival.position, "Arrived within, m", 0.002, 0.5);
  number("--heading-tolerance", arrival.heading, "Arrived within, rad", 0.005, 0.5);
  number("--coarse-tolerance", arrival.coarse_position, "Will do after all corrections, m", 0.002, 1.0);
  number("--coarse-heading-tolerance", arrival.coarse_heading, "Will do after all corrections, rad", 0.005, 1.0);
  app.add_option("--corrections", arrival.corrections, "At the goal, before it takes what it has or gives up")
      ->check(CLI::Range(0, 20))
      ->capture_default_str();
  number("--settle-time", arrival.settle_time, "Standing before the pose is judged, s", 0.1, 10.0);
  TrustParameters& trust = parameters_.trust;
  number("--pose-age", trust.pose_age, "ROBOT_POSE older than that is not driven by, s", 0.05, 2.0);
  number("--scan-age", trust.scan_age, "SONAR_SCAN older than that is not driven by, s", 0.05, 2.0);
  number("--goal-age", trust.goal_age, "A goal not repeated for longer is not followed, s", 0.25, 5.0);
  number("--position-sigma", trust.position_sigma, "Of a pose to drive by, at most, m", 0.01, 1.0);
  number("--heading-sigma", trust.heading_sigma, "Of a pose to drive by, at most, rad", 0.02, 3.0);
  ExploreParameters& explore = parameters_.explore;
  app.add_option("--explore", explore.enabled,
                 "Creep straight on (or back) to learn the heading when only that is unknown")
      ->capture_default_str();
  number("--explore-speed", explore.speed, "m/s", 0.02, 0.5);
  number("--explore-way", explore.way, "m, at most", 0.05, 2.0);
}

void BaseNavigatorNode::add_motion_options(CLI::App& app) {
  const bus::NumberOptions number(app);
  MotionParameters& motion = parameters_.manoeuvre.motion;
  number("--speed", motion.speed, "At most, m/s; a goal may ask for less; never above robot.yaml's", 0.05, 10.0);
  number("--turn-rate", motion.turn_rate, "At most, rad/s; never above robot.yaml's", 0.1, 20.0);
  number("--acceleration", motion.acceleration, "m/s^2; robot.yaml's is used to brake for obstacles", 0.05, 10.0);
  number("--turn-acceleration", motion.turn_acceleration, "rad/s^2", 0.2, 50.0);
  PassageParameters& passage = parameters_.manoeuvre.passage;
  number("--clearance", passage.clearance, "Kept from what the sonars see, m, for goals whose clearance is 0", 0.01,
         2.0);
  number("--turn-clearance", passage.turn_clearance, "Likewise while turning on the spot, at most, m", 0.01, 2.0);
  number("--reaction", passage.reaction, "From an echo to the brakes, s", 0.02, 2.0);
  number("--free-for", passage.free_for, "The way must be free for, before it goes on, s", 0.0, 10.0);
}

void BaseNavigatorNode::configure(const std::string& robot_file) {
  const robot::RobotDescription description = robot::load_robot_description(robot_file);
  robot::require_stop_device(description, "--stop-device", stop_device_, robot_file);
  const ArrivalParameters& arrival = parameters_.manoeuvre.arrival;
  if (arrival.coarse_position < arrival.position || arrival.coarse_heading < arrival.heading) {
    throw ConfigurationError("--coarse-tolerance, --coarse-heading-tolerance: allowed: no less than --tolerance (" +
                             std::to_string(arrival.position) + " m) and --heading-tolerance (" +
                             std::to_string(arrival.heading) + " rad)");
  }
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
  const motion::Word word = base_->hear_stop_state(stamp_of(stop), stop.latched != 0, stop.reason);
  if (word == motion::Word::kReplaced) begin_anew("the base began anew");
  if (word == motion::Word::kAnew) begin_anew("the clock of STOP_STATE was set back");
  const std::string why = motion::why_dropped(word);
  if (why.empty()) navigator_->observe_stop(*base_->latched(), base_->stop_reason(), state_);
  after_input();
  drop(why);
}

void BaseNavigatorNode::on_goal(const BaseGoal& goal) {
  const motion::GoalHeard heard = navigator_->observe(goal_of(goal), state_);
  if (heard == motion::GoalHeard::kContested) base_->raise(state_.goals.two());
  after_input();
  if (heard == motion::GoalHeard::kNew) drop(state_.refusal);
  if (heard == motion::GoalHeard::kBeyond) {
    drop(state_.goals.why_beyond({goal.session, goal.goal_id, goal.utime}));
  }
}

void BaseNavigatorNode::begin_anew(const std::string& why) {
  navigator_->begin_anew(why, state_);
  pacing_ = AnswerPacing();
  pose_.reset();
}

motion::Word BaseNavigatorNode::hear_report(const char* channel, const motion::Stamp& stamp) {
  const motion::Word word = base_->hear_report(channel, stamp);
  if (word == motion::Word::kAnew) begin_anew(std::string("the clock of ") + channel + " was set back");
  after_input();
  drop(motion::why_dropped(word));
  return word;
}

void BaseNavigatorNode::on_scan(const SonarScan& scan) {
  hear_report(channels::kSonarScan.name, stamp_of(scan));
  drop(navigator_->observe(scan_sample(scan), state_));
}

void BaseNavigatorNode::on_odometry(const WheelOdometry& odometry) {
  hear_report(channels::kWheelOdometry.name, stamp_of(odometry));
  heard_odometry_ = std::chrono::steady_clock::now();
  if (const auto overdue = pacing_.next(identity(odometry))) answer(*overdue);
  const std::string problem = navigator_->observe(odometry_sample(odometry), state_);
  if (const auto due = pacing_.due(pose_, kLongestWait_s)) answer(*due);
  drop(problem);
}

void BaseNavigatorNode::on_pose(const RobotPose& pose) {
  const motion::Heard heard = base_->hear_stream(channels::kRobotPose.name, stamp_of(pose));
  after_input();
  drop(motion::why_dropped(heard));
  pose_ = identity(pose);
  navigator_->observe(pose_sample(pose), state_);
  if (const auto due = pacing_.due(pose_, kLongestWait_s)) answer(*due);
}

// What two that claim to be one lead to.
void BaseNavigatorNode::after_input() {
  state_.blocked = base_->blocked();
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
  const std::string others = motion::notice(*base_, state_.goals, parameters_.trust.goal_age);
  if (told_ == state && told_notice_ == others) return;  // reasons may hold numbers that change with every answer
  told_ = state;
  told_notice_ = others;
  std::string words = reason;
  if (!others.empty() && others != reason) words += (reason.empty() ? "" : "; ") + others;
  bus_->set_state(name_of(state), words);
  spdlog::info("{}{}{}", name_of(state), words.empty() ? "" : ": ", words);
}

}  // namespace markservo::base_navigator
