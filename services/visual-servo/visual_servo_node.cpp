#include "services/visual-servo/visual_servo_node.hpp"

#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <stdexcept>

#include "common/bus/number_options.hpp"
#include "common/bus/options.hpp"
#include "common/logging/log.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/motion/notice.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/stop_device.hpp"
#include "services/visual-servo/servo_messages.hpp"

namespace markservo::visual_servo {
namespace {

using messages::drop;
using messages::stamp_of;

// Pictures are known by what is told of them: whoever writes them, or tells so, may be the second.
const char* const kFrames = "STEREO_FRAME (by TARGET_POSE)";

motion::Stamp frame_of(const TargetPose& pose) {
  return {pose.frame_session, pose.frame_seq, pose.frame_utime};
}

}  // namespace
void VisualServoNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  SightParameters& sight = parameters_.sight;
  const bus::NumberOptions number(app);
  const auto count = [&add](const char* name, int& value, const char* what, int min, int max) {
    add.option(name, value, what).in_range(min, max).show_default();
  };
  add.option("--law", law_, "resolved-rate: the arm's Jacobian; paper: one joint per axis (paper eq. 6)")
      .one_of({"resolved-rate", "paper"})
      .show_default();
  add.option("--stop-device", stop_device_, "The arm's name in STOP_STATE, one of robot.yaml's stop_devices")
      .show_default();
  number("--gain", sight.rate.gain, "Part of the remaining way per frame", 0.05, 1.0);
  number("--damping", sight.rate.damping, "Of the Jacobian's inverse, m", 0.001, 0.1);
  number("--joint-speed", sight.rate.joint_speed, "Limit of each joint while servoing, rad/s", 0.05, 10.0);
  number("--grip-speed", sight.rate.grip_speed, "Limit of the grip point, m/s; a goal may ask for less", 0.01, 2.0);
  number("--grip-acceleration", sight.rate.grip_acceleration, "Of the grip point, m/s^2", 0.1, 50.0);
  number("--posture-speed", parameters_.posture.joint_speed, "Limit of the joints towards a posture, rad/s", 0.05,
         10.0);
  number("--posture-acceleration", parameters_.posture.joint_acceleration, "Towards a posture, rad/s^2", 0.1, 100.0);
  number("--tolerance", sight.convergence.tolerance, "Converged within, m, for goals that state none", 0.0002, 0.05);
  number("--fine-tolerance", sight.convergence.fine_tolerance, "Aimed at while corrections help, m", 0.0001, 0.05);
  count("--fine-corrections", sight.convergence.fine_corrections,
        "Corrections after which the goal's tolerance will do", 0, 100);
  number("--back-off", sight.one_sided.back_off, "Against backlash, rad of each joint", 0.0, 0.1);
  number("--last-move", sight.one_sided.last_move, "Into the goal, rad: above a servo's deadband by a quarter", 0.0,
         0.05);
  count("--settled-frames", sight.settling.frames, "Averaged at rest", 1, 30);
  number("--settle-time", sight.settling.settle_time, "From the ramps' end to rest, s", 0.0, 2.0);
  count("--target-frames", parameters_.marks.target.frames, "Averaged over a target that stands still, at most", 1,
        1000);
  number("--pose-age", parameters_.pose_age, "Older pictures are not acted on, s", 0.02, 2.0);
  number("--joint-age", parameters_.joint_age, "Older joint states are not acted on, s", 0.02, 2.0);
  number("--goal-age", parameters_.goal_age, "A goal not repeated for longer is not followed, s", 0.25, 5.0);
  number("--hand-mismatch", parameters_.marks.hand_mismatch, "Most between the hand mark and the joints' word, m",
         0.001, 1.0);
}

void VisualServoNode::configure(const std::string& robot_file) {
  const robot::RobotDescription description = robot::load_robot_description(robot_file);
  robot::require_stop_device(description, "--stop-device", stop_device_, robot_file);
  parameters_.law = law_ == "paper" ? Law::kPaper : Law::kResolvedRate;
  try {
    machine_ = std::make_unique<ServoStateMachine>(description, parameters_);
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(robot_file + ": " + error.what());
  }
}

void VisualServoNode::start(bus::Bus& bus) {
  bus_ = &bus;
  arm_.emplace(stop_device_);
  commands_.emplace(bus.advertise(channels::kJointCommand));
  statuses_.emplace(bus.advertise(channels::kServoStatus));
  stops_.emplace(bus.advertise(channels::kStop));
  bus.on_each(channels::kStopState, [this](const StopState& stop) { on_stop(stop); });
  bus.on_each(channels::kJointState, [this](const JointState& joints) { on_joints(joints); });
  bus.on_each(channels::kServoGoal, [this](const ServoGoal& goal) { on_goal(goal); });
  bus.on_latest(channels::kTargetPose, [this](const TargetPose& pose) { on_pose(pose); });
  bus.need(channels::kTargetPose);
  bus.need(channels::kJointState);
  bus.need(channels::kStopState);
}

void VisualServoNode::on_stop(const StopState& stop) {
  if (stop.device != stop_device_) return;
  const motion::ReportHeard heard = arm_->hear_stop_state(stamp_of(stop), stop.latched != 0, stop.reason);
  if (heard == motion::ReportHeard::kReplaced) {
    machine_->begin_anew("the arm began anew", state_);
    if (strangers_ && strangers_->session == stop.session) machine_->observe(*strangers_, state_);
    strangers_.reset();
  }
  if (heard == motion::ReportHeard::kAnew) machine_->begin_anew("the clock of STOP_STATE was set back", state_);
  const std::string why = motion::why_dropped(heard);
  if (why.empty()) machine_->observe_stop(*arm_->latched(), arm_->stop_reason(), state_);
  after_input();
  drop(why);
}

void VisualServoNode::on_joints(const JointState& joints) {
  const JointSample sample = joint_sample(joints);
  const motion::ReportHeard heard = arm_->hear_report(channels::kJointState.name, stamp_of(joints));
  if (heard == motion::ReportHeard::kForeign) strangers_ = sample;
  if (heard == motion::ReportHeard::kAnew) machine_->begin_anew("the clock of JOINT_STATE was set back", state_);
  const std::string why = motion::why_dropped(heard);
  if (why.empty() && !machine_->observe(sample, state_)) drop("position is not finite");
  after_input();
  drop(why);
}

void VisualServoNode::on_goal(const ServoGoal& goal) {
  const motion::GoalHeard heard = machine_->observe(goal_of(goal), state_);
  if (heard == motion::GoalHeard::kContested) arm_->raise(state_.followed.inbox().two());
  after_input();
  if (heard == motion::GoalHeard::kBeyond) {
    drop(state_.followed.inbox().why_beyond({goal.session, goal.goal_id, goal.utime}));
  }
}

void VisualServoNode::on_pose(const TargetPose& pose) {
  const motion::StreamHeard heard = arm_->hear_stream(channels::kTargetPose.name, stamp_of(pose));
  if (heard == motion::StreamHeard::kLate) drop(motion::why_dropped(heard));
  PoseSample sample = pose_sample(pose);
  if (const auto why = motion::why_dropped(heard); !why.empty()) sample.doubt = "TARGET_POSE " + why;
  if (heard == motion::StreamHeard::kAnew) machine_->begin_pictures_anew(state_);
  if (sample.doubt.empty()) {
    const motion::StreamHeard frame = arm_->hear_stream(kFrames, frame_of(pose));
    if (const auto why = motion::why_dropped(frame); !why.empty()) sample.doubt = "STEREO_FRAME " + why;
    if (frame == motion::StreamHeard::kAnew) machine_->begin_pictures_anew(state_);
  }
  after_input();
  const Output output = machine_->step(sample, state_);
  if (output.command) {
    JointCommand command = command_message(*output.command, pose);
    commands_->publish(command);
  }
  ServoStatus status = status_message(output.status, pose);
  statuses_->publish(status);
  tell(output.status);
}

// What two that claim to be one lead to.
void VisualServoNode::after_input() {
  state_.enable.observe_conflict(arm_->conflict());
  if (const auto wish = arm_->stop_due()) {
    StopRequest stop = messages::stop_request(*wish, arm_->now(), bus_->session(), "visual-servo");
    stops_->publish(stop);
  }
}

void VisualServoNode::tell(const Status& status) {
  const std::string others = motion::notice(*arm_, state_.followed.inbox(), parameters_.goal_age);
  // Reasons may hold numbers that change with every frame.
  if (told_ && told_->state == status.state && told_->notice == others) return;
  told_ = Told{status.state, others};
  std::string reason = status.reason;
  if (!others.empty() && others != reason) reason += (reason.empty() ? "" : "; ") + others;
  bus_->set_state(name_of(status.state), reason);
  logging::info("{}{}{}", name_of(status.state), reason.empty() ? "" : ": ", reason);
}

}  // namespace markservo::visual_servo
