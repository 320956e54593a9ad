#include "services/simulator/world/simulation.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/motion/command_lead.hpp"

namespace markservo::simulator {
namespace {

constexpr std::int64_t kResetPause_us = 1'000'000;

robot::JointVector joint_speeds(const robot::ArmDescription& arm) {
  robot::JointVector speeds;
  for (int i = 0; i < robot::kNumJoints; ++i) speeds[i] = arm.joints[static_cast<std::size_t>(i)].speed;
  return speeds;
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
      time_(epoch),
      control_(session),
      exposures_(start.frames.rate_hz, 0) {}

std::optional<MobileBase> Simulation::new_base(const Settings& settings, std::uint64_t seed, std::int64_t epoch) const {
  if (!robot_.base) return std::nullopt;
  return MobileBase(robot_, scene_.dock.field, settings.base, settings.readers, seed, epoch);
}

void Simulation::reset(std::uint64_t seed, const Assignments& changes) {
  const Settings settings = with_changes(start_, changes);
  World world(robot_, scene_, settings, seed);
  base_ = new_base(settings, seed, utime() + kResetPause_us);
  world_ = std::move(world);
  settings_ = settings;
  seed_ = seed;
  control_.latch("the world was reset", utime());
  delayed_.forget();
  path_.forget();
  time_.leap(kResetPause_us);
  exposures_.begin_anew(settings_.frames.rate_hz, time_.steps());
}

void Simulation::set(const Assignments& changes) {
  const Settings settings = with_changes(settings_, changes);
  check_against_robot(settings, robot_);
  for (const auto& change : changes) require_changeable(change.first);
  const bool new_rate = settings.frames.rate_hz != settings_.frames.rate_hz;
  settings_ = settings;
  world_.change(settings_);
  if (base_) base_->change(settings_.readers);
  if (new_rate) exposures_.change_rate(settings_.frames.rate_hz, time_.steps());
}

motion::StopHeard Simulation::hear_stop(const motion::StopRequestStamp& request) {
  const motion::StopHeard heard = control_.hear_stop(request, utime());
  if (heard == motion::StopHeard::kLatched) freeze();
  // Also where nothing was latched: whoever asked for it begins anew, from the shafts.
  if (heard == motion::StopHeard::kReleased) path_.forget();
  return heard;
}

void Simulation::freeze() {
  if (base_) base_->freeze();
  freeze_arm();
}

void Simulation::freeze_arm() {
  delayed_.forget();
  path_.forget();
  world_.freeze();
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
  answer.verdict = control_.hear_arm(judged, utime());
  if (answer.verdict == motion::CommandVerdict::kLeads) answer.joint = leads;
  if (answer.verdict == motion::CommandVerdict::kJumps) answer.joint = jumps;
  if (answer.verdict == motion::CommandVerdict::kTwoWriters) freeze();
  if (answer.verdict != motion::CommandVerdict::kObeyed) return answer;
  path_.follow(command.position, offered.stamp.utime);
  delayed_.add(effect_of(frame_seq), command);
  return answer;
}

std::int64_t Simulation::effect_of(std::int64_t frame_seq) const {
  if (timing_ == Timing::kRealTime) return utime() + std::llround(settings_.servo.delay_s * 1e6);
  return exposures_.number_of(frame_seq) + std::llround(settings_.servo.delay_frames);
}

motion::CommandVerdict Simulation::command_base(const motion::OfferedCommand& offered, double speed, double turn_rate) {
  if (!base_) return motion::CommandVerdict::kOtherMover;
  const motion::CommandVerdict verdict = control_.hear_base(offered, utime());
  if (verdict == motion::CommandVerdict::kTwoWriters) freeze();
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
  const std::int64_t now = timing_ == Timing::kLockstep ? exposures_.number() : utime();
  if (const auto due = delayed_.take(now)) world_.command(*due);
  if (control_.arm_is_silent(utime())) freeze_arm();
  if (base_) {
    base_->step(world_);
  } else {
    world_.step();
  }
  time_.step();
}

void Simulation::expose(std::int64_t seq) {
  control_.observe_frame(utime());
  exposures_.expose(time_.steps(), seq);
}

NoiseSeeds Simulation::noise() const {
  return noise_seeds(seed_, static_cast<std::uint64_t>(exposures_.number()));
}

}  // namespace markservo::simulator
