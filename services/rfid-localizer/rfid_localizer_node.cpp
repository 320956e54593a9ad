#include "services/rfid-localizer/rfid_localizer_node.hpp"

#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/bus/number_options.hpp"
#include "common/bus/options.hpp"
#include "common/geometry/plane_pose.hpp"
#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/messages/state_codes.hpp"
#include "common/motion/mover_watch.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/states/localisation_state.hpp"
#include "services/rfid-localizer/localizer_messages.hpp"

namespace markservo::rfid_localizer {
void RfidLocalizerNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  const bus::NumberOptions number(app);
  add.option("--method", method_,
             "Whose pose ROBOT_POSE carries: filter, or paper: weighted average, Hough direction, compensated "
             "delay. Its paper part carries the paper's values either way")
      .one_of({"filter", "paper"})
      .show_default();
  add.option("--stop-device", stop_device_, "The base's name in STOP_STATE: whose WHEEL_ODOMETRY counts")
      .show_default();
  add.option("--tag-field", field_, "Field of floor tags in robot.yaml; default: its floor_tags.in_use");
  add.option("--delay", delay_, "From the middle of a reader's round to its arrival, s; default: robot.yaml's")
      .within(0.0, 5.0);
  add.option("--delay-sigma", delay_sigma_,
             "How well that is known, s; default: robot.yaml's. The filter improves on it when the speed changes")
      .within(0.0, 1.0);
  add.option("--start-heading", start_heading_deg_, "The robot's heading at the start, deg; default: not known")
      .within(-360.0, 360.0);
  number("--start-heading-sigma", start_heading_sigma_deg_, "How well that is known, deg", 0.1, 60.0);
  number("--slip-margin", slip_margin_, "On robot.yaml's drift of the heading: what floors add to it", 1.0, 10.0);
  number("--lost-sigma", parameters_.trust.largest_sigma, "Position less well known counts as lost, m", 0.01, 10.0);
  number("--silence", parameters_.trust.silence, "Lost without any round of the reader for so long, s", 0.2, 60.0);
}

void RfidLocalizerNode::configure(const std::string& robot_file) {
  const robot::RobotDescription robot = robot::load_robot_description(robot_file);
  if (!robot.rfid) throw ConfigurationError(robot_file + ": section 'rfid' is missing; allowed: a robot with a reader");
  if (!robot.floor_tags) {
    throw ConfigurationError(robot_file + ": section 'floor_tags' is missing; allowed: a map of tags");
  }
  const TrustParameters told = parameters_.trust;
  parameters_ = parameters_of(robot, slip_margin_);
  parameters_.trust = told;
  if (delay_) parameters_.delay.mean = parameters_.paper.delay = *delay_;
  if (delay_sigma_) parameters_.delay.sigma = *delay_sigma_;
  if (start_heading_deg_) {
    parameters_.start_heading =
        HeadingPrior{geometry::radians(*start_heading_deg_), geometry::radians(start_heading_sigma_deg_)};
  }
  robot_ = robot;
  begin();
}

void RfidLocalizerNode::begin() {
  const robot::BaseDescription base = robot_.base.value_or(robot::BaseDescription{});
  localizer_ = std::make_unique<Localizer>(base, *robot_.rfid, robot_.floor_tags->field(field_), parameters_);
}

void RfidLocalizerNode::start(bus::Bus& bus) {
  bus_ = &bus;
  poses_.emplace(bus.advertise(channels::kRobotPose));
  base_.emplace(stop_device_);
  bus.on_each(channels::kStopState, [this](const StopState& stop) {
    if (stop.device == stop_device_) base_->hear_stop_state(messages::stamp_of(stop), stop.latched != 0);
  });
  bus.on_each(channels::kRfidTagHits, [this](const RfidTagHits& message) {
    const motion::Heard heard = rounds_.hear(messages::stamp_of(message), base_->newest_utime());
    // Who has the floor is believed though another one speaks too.
    if (heard != motion::Heard::kSecond) messages::drop(motion::why_dropped(heard));
    localizer_->observe(tag_round(message));
    if (!localizer_->has_wheels()) publish(message.utime, 0, 0);
  });
  bus.on_each(channels::kWheelOdometry, [this](const WheelOdometry& message) {
    const motion::Word word = base_->hear_report(channels::kWheelOdometry.name, messages::stamp_of(message));
    messages::drop(motion::why_dropped(word));
    if (word == motion::Word::kAnew) {
      // Its clock was set back: all that is known has times to come, and the heading at the start is past.
      parameters_.start_heading.reset();
      begin();
    }
    localizer_->observe(encoder_reading(message));
    publish(message.utime, message.session, message.seq);
  });
  bus.need(channels::kRfidTagHits);  // it works without encoders, as the paper does
}

void RfidLocalizerNode::publish(std::int64_t utime, std::int64_t odometry_session, std::int64_t odometry_seq) {
  RobotPose pose = pose_message(localizer_->estimate(utime), utime, method_ == "paper");
  pose.odometry_session = odometry_session;
  pose.odometry_seq = odometry_seq;
  poses_->publish(pose);
  tell(pose);
}

void RfidLocalizerNode::tell(const RobotPose& pose) {
  const WheelJudgement wheels = localizer_->wheel_judgement();
  const std::string news = wheel_report_.news(wheels);
  if (!news.empty()) logging::warn("{}", news);
  const char* state = name_of(messages::state_of<LocalisationState>(pose.state));
  const bool changed = told_ != state;
  // Counts that grow with every round would be a stream of their own.
  if (!changed && !tell_timer_.due(pose.utime)) return;
  const LocalizerFaults faults = localizer_->faults();
  std::string what = pose.reason;
  const auto add = [&what](std::int64_t count, const char* name) {
    if (count > 0) what += (what.empty() ? "" : "; ") + std::to_string(count) + " " + name;
  };
  add(faults.unknown_tags, "reads of tags that the map does not have");
  add(faults.far_tags, "reads of tags out of reach");
  add(faults.repeated_reads, "tags read twice in a round");
  add(faults.late_rounds, "rounds out of order");
  add(faults.wrong_windows, "rounds with an impossible window");
  add(faults.late_odometry, "odometry out of order");
  add(faults.tick_jumps, "jumps of the encoders");
  const std::string worse = describe(wheels);
  if (!worse.empty()) what += (what.empty() ? "" : "; ") + worse;
  bus_->set_state(state, what);
  if (!changed) return;
  told_ = state;
  logging::info("{}{}{}", told_, pose.reason.empty() ? "" : ": ", pose.reason);
}

}  // namespace markservo::rfid_localizer
