#include "services/rfid-localizer/rfid_localizer_node.hpp"

#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/messages/state_codes.hpp"
#include "common/motion/mover_watch.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/states/localisation_state.hpp"
#include "services/rfid-localizer/localizer_messages.hpp"

namespace markservo::rfid_localizer {

void RfidLocalizerNode::add_options(CLI::App& app) {
  add_localizer_options(app, options_);
}

void RfidLocalizerNode::configure(const std::string& robot_file) {
  const robot::RobotDescription robot = robot::load_robot_description(robot_file);
  if (!robot.rfid) throw ConfigurationError(robot_file + ": section 'rfid' is missing; allowed: a robot with a reader");
  if (!robot.floor_tags) {
    throw ConfigurationError(robot_file + ": section 'floor_tags' is missing; allowed: a map of tags");
  }
  parameters_ = localizer_parameters(options_, robot);
  robot_ = robot;
  begin();
}

void RfidLocalizerNode::begin() {
  const robot::BaseDescription base = robot_.base.value_or(robot::BaseDescription{});
  localizer_ =
      std::make_unique<Localizer>(base, *robot_.rfid, robot_.floor_tags->field(options_.tag_field), parameters_);
  // Else the judge, which knows nothing yet, would seem to call the wheels good again.
  wheel_report_ = WheelReport();
}

void RfidLocalizerNode::start(bus::Bus& bus) {
  bus_ = &bus;
  poses_.emplace(bus.advertise(channels::kRobotPose));
  base_.emplace(options_.stop_device);
  bus.on_each(channels::kStopState, [this](const StopState& stop) {
    if (stop.device == options_.stop_device) base_->hear_stop_state(messages::stamp_of(stop), stop.latched != 0);
  });
  bus.on_each(channels::kRfidTagHits, [this](const RfidTagHits& message) {
    const motion::StreamHeard heard = rounds_.hear(messages::stamp_of(message), base_->newest_utime());
    // Who has the floor is believed though another one speaks too.
    if (heard != motion::StreamHeard::kSecond) messages::drop(motion::why_dropped(heard));
    localizer_->observe(tag_round(message));
    if (!localizer_->has_wheels()) publish(message.utime, 0, 0);
  });
  bus.on_each(channels::kWheelOdometry, [this](const WheelOdometry& message) {
    const motion::ReportHeard heard = base_->hear_report(channels::kWheelOdometry.name, messages::stamp_of(message));
    messages::drop(motion::why_dropped(heard));
    if (heard == motion::ReportHeard::kAnew) {
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
  RobotPose pose = pose_message(localizer_->estimate(utime), utime, options_.method == "paper");
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
