#include "services/simulator/simulator_node.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iostream>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <utility>

#include "common/bus/network_check.hpp"
#include "common/messages/motion_messages.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/simulator/messages.hpp"
#include "services/simulator/real_time_pace.hpp"
#include "services/simulator/scene_model.hpp"

namespace markservo::simulator {
namespace {

using std::chrono::milliseconds;

constexpr std::int64_t kJointStatePeriod_us = 10'000;

std::vector<std::string> answering_channels() {
  std::vector<std::string> names = {channels::kJointCommand.name,  channels::kTaskState.name,
                                    channels::kServoStatus.name,   channels::kTargetPose.name,
                                    channels::kMarkDetection.name, channels::kSimControl.name};
  for (const std::string& name : BaseNode::answering_channels()) names.push_back(name);
  return names;
}

bool answers_odometry(const std::string& channel) {
  const auto& names = BaseNode::answering_channels();
  return std::find(names.begin(), names.end(), channel) != names.end();
}

std::string settings_help() {
  std::string names;
  for (const auto& setting : setting_descriptions()) names += std::string(names.empty() ? "" : ", ") + setting.name;
  return "A setting, name=value, repeatable (--list-settings explains them): " + names;
}

}  // namespace

void SimulatorNode::add_options(CLI::App& app) {
  app.add_option("--scene", scene_file_, "The world around the robot")->capture_default_str();
  app.add_option("--seed", seed_, "Seed of all that is random")->check(CLI::NonNegativeNumber)->capture_default_str();
  app.add_option("--set", assignments_, settings_help());
  app.add_flag("--lockstep", lockstep_, "Stand still until every awaited channel has answered the frame or odometry");
  app.add_option("--wait-for", wait_for_, "Channels awaited in lockstep")
      ->delimiter(',')
      ->check(CLI::IsMember(answering_channels()))
      ->capture_default_str();
  app.add_option("--lockstep-timeout", lockstep_timeout_s_,
                 "Wait for answers at most this long, s; then the run is invalid")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  app.add_option("--encoding", encoding_, "raw, jpeg, or auto: raw where the network's buffers hold it")
      ->check(CLI::IsMember({"auto", "raw", "jpeg"}))
      ->capture_default_str();
  app.add_option("--jpeg-quality", jpeg_quality_, "1 to 100")->check(CLI::Range(1, 100))->capture_default_str();
  app.add_option("--snapshot", snapshot_, "Write one picture pair, side by side, to this file and exit")
      ->configurable(false);
  app.add_flag("--list-settings", list_settings_, "Print all settings with values and meaning and exit")
      ->configurable(false);
}

void SimulatorNode::configure(const std::string& robot_file) {
  robot_ = robot::load_robot_description(robot_file);
  scene_ = load_scene(scene_file_, robot_);
  settings_ = default_settings(robot_, scene_, lockstep_);
  for (const std::string& assignment : assignments_) set_from_text(settings_, assignment);
  check_against_robot(settings_, robot_);
  if (lockstep_ && !robot_.base && std::any_of(wait_for_.begin(), wait_for_.end(), answers_odometry)) {
    throw ConfigurationError("--wait-for names an answer to WHEEL_ODOMETRY; allowed: with section 'base' in " +
                             robot_file);
  }
  if (list_settings_) return;
  try {
    renderer_ = std::make_unique<StereoRenderer>();
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(error.what());
  }
}

std::optional<int> SimulatorNode::run_alone() {
  if (list_settings_) {
    std::cout << list_settings(settings_);
    return bus::kExitStopped;
  }
  if (snapshot_.empty()) return std::nullopt;
  simulation_ =
      std::make_unique<Simulation>(robot_, scene_, settings_, static_cast<std::uint64_t>(seed_), Timing::kLockstep, 0);
  simulation_->expose(1);
  simulation_->world().truth();
  const ImagePair images = draw();
  cv::Mat both;
  cv::hconcat(images.left, images.right, both);
  bool written = false;
  try {
    written = cv::imwrite(snapshot_, both);
  } catch (const cv::Exception&) {  // a file name that OpenCV knows no format for
  }
  if (!written)
    throw ConfigurationError("--snapshot is '" + snapshot_ + "'; allowed: a .png or .jpg that can be written");
  return bus::kExitStopped;
}

void SimulatorNode::start(bus::Bus& bus) {
  const Timing timing = lockstep_ ? Timing::kLockstep : Timing::kRealTime;
  // In real time commands are judged by the wall clock, so that an old recording's are old to a young world too.
  const std::int64_t epoch = lockstep_ ? kEpoch_us : wall_clock_us();
  simulation_ = std::make_unique<Simulation>(robot_, scene_, settings_, static_cast<std::uint64_t>(seed_), timing,
                                             bus.session(), epoch);
  choose_encoding(bus.urls());
  frames_ = bus.advertise(channels::kStereoFrame);
  joint_states_ = bus.advertise(channels::kJointState);
  stop_states_ = bus.advertise(channels::kStopState);
  truths_ = bus.advertise(channels::kSimTruth);
  subscribe(bus);
  // The first picture takes some 0.4 s: here, not when time already runs.
  simulation_->world().truth();
  draw();
}

void SimulatorNode::choose_encoding(const bus::BusUrls& urls) {
  raw_ = encoding_ == "raw";
  if (encoding_ != "auto") return;
  raw_ = bus::raw_frames_fit(urls.out);
  if (!raw_) spdlog::warn("{}", bus::raw_frames_advice());
}

void SimulatorNode::subscribe(bus::Bus& bus) {
  bus.on_each(channels::kJointCommand, [this](const JointCommand& message) { on_joint_command(message); });
  bus.on_each(channels::kStop, [this](const StopRequest& message) { on_stop(message); });
  bus.on_each(channels::kSimControl, [this](const SimControl& message) { on_control(message); });
  std::vector<std::string> frame_answers;
  std::vector<std::string> odometry_answers;
  if (lockstep_) {
    for (const std::string& channel : wait_for_) {
      (answers_odometry(channel) ? odometry_answers : frame_answers).push_back(channel);
    }
  }
  if (simulation_->has_base()) base_ = std::make_unique<BaseNode>(bus, *simulation_, odometry_answers);
  barrier_ = LockstepBarrier(frame_answers);
  for (const std::string& channel : frame_answers) await_channel(bus, channel);
}

void SimulatorNode::await_channel(bus::Bus& bus, const std::string& channel) {
  const auto await = [&](const auto& awaited) {
    if (channel != awaited.name) return;
    bus.on_each(awaited, [this, channel](const auto& message) {
      barrier_.note(channel, message.frame_session, message.frame_seq);
    });
  };
  await(channels::kTaskState);
  await(channels::kServoStatus);
  await(channels::kTargetPose);
  await(channels::kMarkDetection);
  // JOINT_COMMAND and SIM_CONTROL are subscribed anyway; their handlers tell the barrier.
}

void SimulatorNode::on_joint_command(const JointCommand& message) {
  const motion::OfferedCommand offered{messages::command_stamp(message), message.joint_session};
  const CommandAnswer answer = simulation_->command(offered, message.frame_seq, arm_command(message));
  barrier_.note(channels::kJointCommand.name, message.frame_session, message.frame_seq);
  tell_of_a_latch();
  const std::string command = "command for frame " + std::to_string(message.frame_seq) + " ";
  const std::string joint = answer.joint ? "joint " + robot_.arm->joints[*answer.joint].name + ": " : "";
  switch (answer.verdict) {
    case motion::CommandVerdict::kObeyed:
    case motion::CommandVerdict::kLatched:      // commands go on while the arm is stopped
    case motion::CommandVerdict::kBeforeReset:  // and those under way at a reset come late
      break;
    default:
      messages::drop(joint + command + motion::describe(answer.verdict));
  }
}

void SimulatorNode::on_stop(const StopRequest& message) {
  if (message.kind != StopRequest::STOP && message.kind != StopRequest::RESET) {
    messages::drop("kind is " + std::to_string(message.kind) + "; allowed: 0 (stop) or 1 (reset)");
  }
  motion::StopRequestStamp request{{message.session, message.request_id, message.utime},
                                   message.kind == StopRequest::RESET,
                                   (message.source.empty() ? "someone" : message.source) + ": " + message.reason};
  const motion::StopHeard heard = simulation_->request(request);
  if (heard == motion::StopHeard::kStale) messages::drop("RESET refused: " + simulation_->why_stale(request));
  if (heard != motion::StopHeard::kAgain) {
    spdlog::info("STOP {}: {}", simulation_->latch().latched() ? "latched" : "reset", simulation_->latch().reason());
  }
  publish_stop_states();
}

void SimulatorNode::on_control(const SimControl& message) {
  if (message.kind == SimControl::STEP) {
    barrier_.note(channels::kSimControl.name, message.frame_session, message.frame_seq);
    return;
  }
  const motion::CommandStamp stamp{message.session, message.control_id, message.utime};
  const motion::CommandHeard heard = controls_.hear(stamp, simulation_->utime(), false);
  if (heard == motion::CommandHeard::kStale) messages::drop(controls_.why_stale(stamp, simulation_->utime()));
  if (heard == motion::CommandHeard::kExecute) {
    control_error_.clear();
    try {
      obey_control(message);
    } catch (const std::exception& error) {
      // Whatever it was: the sender waits for an echo, and silence about a failure would read as done.
      control_error_ = error.what();
      spdlog::warn("SIM_CONTROL {}: {}", message.control_id, control_error_);
    }
  }
  // A reset's echo comes with its first frame; everything else is echoed at once.
  if (!world_is_new_ && frame_seq_ > 0) publish_truth();
}

void SimulatorNode::obey_control(const SimControl& message) {
  Assignments changes;
  for (const SimParameter& parameter : message.parameters) changes.emplace_back(parameter.name, parameter.value);
  if (message.kind == SimControl::SET) {
    simulation_->set(changes);
    return;
  }
  if (message.seed < 0) throw ConfigurationError("seed is " + std::to_string(message.seed) + "; allowed: 0 or more");
  simulation_->reset(static_cast<std::uint64_t>(message.seed), changes);
  valid_ = true;
  world_is_new_ = true;
  ++resets_;
}

void SimulatorNode::run(bus::Bus& bus) {
  if (lockstep_) {
    run_lockstep(bus);
  } else {
    run_real_time(bus);
  }
}

void SimulatorNode::run_lockstep(bus::Bus& bus) {
  while (true) {
    const std::int64_t resets = resets_;
    if (publish_base() && !wait_for_answers(bus, odometry_wait_, base_->barrier(), "an odometry")) return;
    if (resets != resets_) continue;
    if (!world_is_new_ && frame_seq_ > 0 && !simulation_->frame_due()) {
      step();
      continue;
    }
    expose_frame();
    const bool lost = simulation_->dropped();
    if (!lost && !wait_for_answers(bus, frame_wait_, barrier_, "a frame")) return;
    if (lost && !bus.poll(milliseconds(0))) return;
    if (resets == resets_) step();
  }
}

bool SimulatorNode::wait_for_answers(bus::Bus& bus, LockstepNode& wait, const LockstepBarrier& barrier,
                                     const char* what) {
  resets_before_wait_ = resets_;
  const LockstepNode::Outcome outcome = wait.run(bus, barrier, lockstep_timeout_s_);
  if (outcome == LockstepNode::Outcome::kTimedOut) {
    if (valid_) {
      spdlog::error("{}, {} us after the epoch: no answer on {} within {} s: this run is invalid until the next RESET",
                    what, simulation_->elapsed_us(), barrier.missing(), lockstep_timeout_s_);
    }
    valid_ = false;
  }
  return outcome != LockstepNode::Outcome::kEnded;
}

void SimulatorNode::run_real_time(bus::Bus& bus) {
  bus.set_state("real time");
  RealTimePace pace(simulation_->utime(), steady_clock_us());
  while (true) {
    const std::int64_t wait_us = pace.wait(simulation_->utime(), steady_clock_us());
    if (!bus.poll(std::chrono::ceil<milliseconds>(std::chrono::microseconds(wait_us)))) return;
    tell_of_a_latch();
    if (pace.wait(simulation_->utime(), steady_clock_us()) > 0) continue;
    publish_base();
    if (world_is_new_ || simulation_->frame_due()) expose_frame();
    // In bites of one joint state, so that commands are taken in at 100 Hz.
    do {
      step();
      publish_base();
    } while (!simulation_->frame_due() && !world_is_new_ && simulation_->elapsed_us() % kJointStatePeriod_us != 0);
  }
}

void SimulatorNode::step() {
  try {
    simulation_->step();
  } catch (const std::runtime_error& error) {
    spdlog::error("{}: the world begins anew, this run is invalid", error.what());
    simulation_->reset(simulation_->seed(), {});
    valid_ = false;
    world_is_new_ = true;
    ++resets_;
  }
  const bool exposure = simulation_->frame_due();  // then the joints are told at the exposure itself
  if (exposure || simulation_->elapsed_us() % kJointStatePeriod_us == 0) publish_joint_state();
  if (stop_state_timer_.due(simulation_->utime())) publish_stop_states();
}

void SimulatorNode::expose_frame() {
  const bool repeated = frame_seq_ > 0 && !world_is_new_ && truth_.utime == simulation_->utime();
  if (world_is_new_ || repeated || frame_seq_ == 0) {
    publish_joint_state();
    publish_stop_states();
  }
  world_is_new_ = false;
  simulation_->expose(++frame_seq_);
  if (repeated) {
    barrier_.expect_also(frame_seq_);
  } else {
    barrier_.expect(frames_->session(), frame_seq_);
  }
  truth_ = truth_message(simulation_->world().truth());
  truth_.utime = truth_.frame_utime = simulation_->utime();
  truth_.frame_session = frames_->session();
  truth_.frame_seq = frame_seq_;
  publish_truth();
  if (simulation_->dropped()) {
    frames_->skip();
    return;
  }
  StereoFrame frame = frame_message(robot_.cameras, simulation_->settings(), draw(), raw_ ? 0 : jpeg_quality_);
  frame.utime = simulation_->utime();
  frames_->publish(frame);
}

ImagePair SimulatorNode::draw() {
  const World& world = simulation_->world();
  ImagePair images = renderer_->render(world);
  apply_effects(simulation_->effects(), simulation_->noise_seed_of(0), images.left);
  apply_effects(simulation_->effects(), simulation_->noise_seed_of(1), images.right);
  return lying_.show(simulation_->settings(), std::move(images));
}

void SimulatorNode::publish_truth() {
  truth_.control_session = controls_.session();
  truth_.control_id = controls_.id();
  truth_.control_error = control_error_;
  truth_.valid = valid_ ? 1 : 0;
  truths_->publish(truth_);
}

void SimulatorNode::publish_joint_state() {
  JointState message = joint_state_message(lying_.tell(simulation_->settings(), simulation_->world().arm()));
  message.utime = simulation_->utime();
  joint_states_->publish(message);
}

void SimulatorNode::publish_stop_states() {
  // After a reset the world's time is ahead until the second that it leapt by has passed; then all is told.
  if (world_is_new_ && !lockstep_) return;
  StopState message{};
  message.utime = simulation_->utime();
  const motion::StopLatch& latch = simulation_->latch();
  message.latched = latch.latched() ? 1 : 0;
  message.request_session = latch.session();
  message.request_id = latch.id();
  message.reason = latch.reason();
  message.device = "arm";
  stop_states_->publish(message);
  if (base_) {
    message.device = "base";
    stop_states_->publish(message);
  }
  stop_state_timer_.restart(message.utime);
  told_latched_ = latch.latched();
}

// Two writers of its commands latch the world by themselves.
void SimulatorNode::tell_of_a_latch() {
  if (simulation_->latch().latched() == told_latched_ || (world_is_new_ && !lockstep_)) return;
  spdlog::warn("STOP latched: {}", simulation_->latch().reason());
  publish_stop_states();
}

void SimulatorNode::repeat_odometry() {
  publish_stop_states();
  base_->repeat();
}

bool SimulatorNode::publish_base() {
  return base_ && base_->publish_due();
}

}  // namespace markservo::simulator
