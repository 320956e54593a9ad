#include "services/simulator/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/motion/command_lead.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/simulator/random.hpp"
#include "services/simulator/scene_model.hpp"

namespace markservo::simulator {
namespace {

const std::int64_t kStep_us = std::llround(kTimeStep * 1e6);
constexpr std::int64_t kResetPause_us = 1'000'000;

robot::JointVector joint_speeds(const robot::ArmDescription& arm) {
  robot::JointVector speeds;
  for (int i = 0; i < robot::kNumJoints; ++i) speeds[i] = arm.joints[static_cast<std::size_t>(i)].speed;
  return speeds;
}

Settings with(Settings settings, const Assignments& changes) {
  for (const auto& [name, value] : changes) set_value(settings, name, value);
  return settings;
}

void require_changeable(const std::string& name) {
  for (const SettingDescription& setting : setting_descriptions()) {
    if (name == setting.name && setting.takes_effect == TakesEffect::kAtReset) {
      throw ConfigurationError("setting '" + name + "' cannot change in the running world; allowed: with RESET");
    }
  }
}

}  // namespace

Simulation::Simulation(robot::RobotDescription robot, Scene scene, const Settings& start, std::uint64_t seed,
                       Timing timing, std::int64_t session, std::int64_t epoch)
    : robot_(std::move(robot)),
      scene_(std::move(scene)),
      start_(start),
      settings_(start),
      seed_(seed),
      timing_(timing),
      world_(robot_, scene_, start, seed),
      base_(new_base(start, seed, epoch)),
      epoch_(epoch),
      gate_("JOINT_COMMAND", session),
      base_gate_("BASE_COMMAND", session),
      schedule_(start.frames_rate_hz, kTimeStep, 0) {}

std::optional<MobileBase> Simulation::new_base(const Settings& settings, std::uint64_t seed, std::int64_t epoch) const {
  if (!robot_.base) return std::nullopt;
  return MobileBase(robot_, scene_, settings, seed, epoch);
}

void Simulation::reset(std::uint64_t seed, const Assignments& changes) {
  const Settings settings = with(start_, changes);
  World world(robot_, scene_, settings, seed);
  base_ = new_base(settings, seed, utime() + kResetPause_us);
  world_ = std::move(world);
  settings_ = settings;
  seed_ = seed;
  latch_.latch("the world was reset", utime());
  delayed_.clear();
  step_count_ += kResetPause_us / kStep_us;
  frame_number_ = 0;
  exposed_step_ = -1;
  schedule_ = FrameSchedule(settings_.frames_rate_hz, kTimeStep, step_count_);
}

void Simulation::set(const Assignments& changes) {
  const Settings settings = with(settings_, changes);
  check_against_robot(settings, robot_);
  for (const auto& change : changes) require_changeable(change.first);
  const bool new_rate = settings.frames_rate_hz != settings_.frames_rate_hz;
  settings_ = settings;
  world_.change(settings_);
  if (base_) base_->change(settings_);
  if (new_rate) restart_schedule();
}

void Simulation::restart_schedule() {
  schedule_ = FrameSchedule(settings_.frames_rate_hz, kTimeStep, exposed_step_ >= 0 ? exposed_step_ : step_count_);
  if (exposed_step_ >= 0) schedule_.advance();
}

motion::StopHeard Simulation::request(const motion::StopRequestStamp& request) {
  std::string obstacle = gate_.obstacle(utime());
  if (obstacle.empty()) obstacle = base_gate_.obstacle(utime());
  const motion::StopHeard heard = latch_.hear(request, utime(), obstacle);
  if (heard == motion::StopHeard::kLatched) freeze();
  if (heard == motion::StopHeard::kReleased) release();
  return heard;
}

void Simulation::freeze() {
  if (base_) base_->freeze();
  delayed_.clear();
  path_.forget();
  world_.freeze();
}

void Simulation::release() {
  path_.forget();
  gate_.release(frame_utime_);
  base_gate_.release(odometry_utime_);
}

CommandAnswer Simulation::command(const motion::OfferedCommand& offered, std::int64_t frame_seq,
                                  const ArmCommand& command) {
  // A command's own limit may be any number; the servo's speed is what it moves by.
  const robot::JointVector speed = command.speed_limit.cwiseMin(joint_speeds(*robot_.arm));
  const robot::JointVector shaft = world_.arm().position;
  const auto leads = motion::leading_joint(command.position, speed, shaft);
  const auto jumps = path_.jumping_joint(command.position, speed, shaft, offered.stamp.utime);
  CommandAnswer answer;
  motion::OfferedCommand judged = offered;
  judged.leads = leads.has_value();
  judged.jumps = jumps.has_value();
  answer.verdict = gate_.offer(judged, utime(), latch_.latched());
  if (answer.verdict == motion::CommandVerdict::kLeads) answer.joint = leads;
  if (answer.verdict == motion::CommandVerdict::kJumps) answer.joint = jumps;
  if (answer.verdict == motion::CommandVerdict::kTwoWriters) {
    latch_.latch(gate_.two_writers(), utime());
    freeze();
  }
  if (answer.verdict != motion::CommandVerdict::kObeyed) return answer;
  path_.follow(command.position, offered.stamp.utime);
  if (timing_ == Timing::kLockstep) {
    const std::int64_t answered_number = frame_number_ - std::max<std::int64_t>(0, first_seq_ - frame_seq);
    delayed_.add(answered_number + std::llround(settings_.servo_delay_frames), command);
  } else {
    delayed_.add(utime() + std::llround(settings_.servo_delay_s * 1e6), command);
  }
  return answer;
}

motion::CommandVerdict Simulation::command_base(const motion::OfferedCommand& offered, double speed, double turn_rate) {
  if (!base_) return motion::CommandVerdict::kOtherMover;
  const auto verdict = base_gate_.offer(offered, utime(), latch_.latched());
  if (verdict == motion::CommandVerdict::kTwoWriters) {
    latch_.latch(base_gate_.two_writers(), utime());
    freeze();
  }
  if (verdict == motion::CommandVerdict::kObeyed) base_->command(speed, turn_rate);
  return verdict;
}

MobileBaseOutputs Simulation::take_due() {
  return base_ ? base_->take_due(world_) : MobileBaseOutputs{};
}

MobileBaseTruth Simulation::base_truth() const {
  if (!base_) throw std::logic_error("Simulation: the robot has no base");
  return base_->truth(world_);
}

void Simulation::step() {
  const std::int64_t now = timing_ == Timing::kLockstep ? frame_number_ : utime();
  if (const auto due = delayed_.take(now)) world_.command(*due);
  if (gate_.silent(utime())) {
    delayed_.clear();
    path_.forget();
    world_.freeze();
  }
  if (base_) {
    base_->step(world_);
  } else {
    world_.step();
  }
  ++step_count_;
}

std::int64_t Simulation::utime() const {
  return epoch_ + elapsed_us();
}

std::int64_t Simulation::elapsed_us() const {
  return step_count_ * kStep_us;
}

void Simulation::expose(std::int64_t seq) {
  frame_utime_ = utime();
  if (exposed_step_ == step_count_) return;
  exposed_step_ = step_count_;
  first_seq_ = seq;
  ++frame_number_;
  schedule_.advance();
}

bool Simulation::dropped() const {
  constexpr std::uint64_t kStream = 0x33;
  return RandomBits(seed_for(seed_, kStream, frame_number())).uniform() < settings_.frames_drop_rate;
}

ImageEffects Simulation::effects() const {
  ImageEffects effects;
  effects.blur_px = settings_.image_blur_px;
  effects.gain_red = settings_.light_gain * settings_.light_cast_red;
  effects.gain_green = settings_.light_gain * settings_.light_cast_green;
  effects.gain_blue = settings_.light_gain * settings_.light_cast_blue;
  effects.noise_sigma = settings_.image_noise_sigma;
  return effects;
}

}  // namespace markservo::simulator
