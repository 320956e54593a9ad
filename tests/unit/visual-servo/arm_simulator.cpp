#include "tests/unit/visual-servo/arm_simulator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/robot/arm_kinematics.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr double kTick_s = 1.0 / 600.0;  // divides frames and joint states
constexpr double kStateInterval_s = 0.01;
constexpr double kGripperSpeed = 0.1;  // m/s
constexpr std::int64_t kEpoch_us = 1'700'000'000'000'000;

double towards(double from, double to, double largest) {
  return from + std::clamp(to - from, -largest, largest);
}

std::int64_t utime_of(double seconds) {
  return kEpoch_us + std::llround(seconds * 1e6);
}

}  // namespace

std::int64_t ArmSimulator::utime() const {
  return utime_of(time_);
}

ArmSimulator::ArmSimulator(const robot::RobotDescription& robot, const SimulatorSettings& settings, std::uint64_t seed)
    : robot_(robot), truth_(*robot.arm), settings_(settings), random_(seed) {
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int axis = 0; axis < 3; ++axis) truth_.p_CA[axis] += settings.base_error * part(random_);
  truth_.upper_arm *= 1.0 + settings.link_error * part(random_);
  truth_.forearm *= 1.0 + settings.link_error * part(random_);
}

void ArmSimulator::place(const JointVector& q, const Eigen::Vector3d& p_CT) {
  joints_.clear();
  for (int i = 0; i < robot::kNumJoints; ++i) joints_.emplace_back(q[i]);
  p_CT_ = p_CT;
  path_ = {grip_point()};
  deepest_y_ = path_.front().y();
}

PoseSample ArmSimulator::expose() {
  PoseSample pose;
  pose.utime = utime_of(frame_time_);
  pose.frame_session = 1;
  const Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity() * std::pow(settings_.vision_sigma, 2);
  pose.marks.push_back(
      {"hand", !hide_hand, hide_hand ? "hidden" : "", robot::hand_mark(truth_, shafts()) + noise(), covariance});
  pose.marks.push_back({"red_book", !hide_target, hide_target ? "hidden" : "", p_CT_ + noise(), covariance});
  if (states_.empty() || states_.back().utime != pose.utime) report_joints();  // as the project's simulator does
  poses_.push_back(pose);
  const std::size_t kept = settings_.delay_in_vision ? static_cast<std::size_t>(settings_.delay_frames) : 1;
  while (poses_.size() > kept) poses_.pop_front();
  return poses_.front();
}

std::deque<JointSample> ArmSimulator::take_joint_states() {
  return std::exchange(states_, {});
}

void ArmSimulator::finish_frame(const std::optional<Command>& command) {
  const int frames = settings_.delay_in_vision ? 1 : settings_.delay_frames;
  if (command) {
    const std::int64_t answered = poses_.front().utime;
    if (commanded_.jumping_joint(command->position, command->speed_limit, shafts(), answered)) ++jumps_;
    commanded_.follow(command->position, answered);
    pending_.push_back({frame_time_ + frames / settings_.frame_rate - 1e-9, *command});
  }
  frame_time_ += 1.0 / settings_.frame_rate;
  run_until(frame_time_);
}

void ArmSimulator::run_until(double time) {
  while (time_ + 0.5 * kTick_s < time) tick();
}

void ArmSimulator::tick() {
  while (!pending_.empty() && pending_.front().due <= time_ + 1e-9) {
    if (!stopped) {
      const Command& command = pending_.front().command;
      for (int i = 0; i < robot::kNumJoints; ++i) {
        joints_[static_cast<std::size_t>(i)].command(command.position[i], command.speed_limit[i]);
      }
      opening_target_ = command.gripper_opening;
    }
    pending_.pop_front();
  }
  if (stopped) {
    for (auto& joint : joints_) joint.freeze();
    opening_target_ = std::min(opening, opening_target_);
    if (opening > object_width) opening_target_ = opening;
  }
  opening = towards(opening, std::max(opening_target_, object_width), kGripperSpeed * kTick_s);
  for (int i = 0; i < robot::kNumJoints; ++i) joints_[static_cast<std::size_t>(i)].step(servo(i), kTick_s);
  time_ += kTick_s;
  path_.push_back(grip_point());
  deepest_y_ = std::max(deepest_y_, path_.back().y());
  if (time_ + 1e-9 >= next_state_) {
    report_joints();
    next_state_ += kStateInterval_s;
  }
}

void ArmSimulator::report_joints() {
  states_.push_back({utime_of(time_), 7, settings_.measured ? shafts() : ramps(), opening, false});
}

simulator::ServoParameters ArmSimulator::servo(int joint) const {
  simulator::ServoParameters parameters;
  parameters.speed = truth_.joints[static_cast<std::size_t>(joint)].speed;
  parameters.acceleration = settings_.acceleration;
  parameters.deadband = settings_.servos.deadband_rad;
  parameters.deadband_kind = settings_.servos.deadband;
  parameters.backlash = settings_.servos.backlash_rad;
  return parameters;
}

JointVector ArmSimulator::ramps() const {
  return {joints_[0].ramp(), joints_[1].ramp(), joints_[2].ramp()};
}

JointVector ArmSimulator::shafts() const {
  return {joints_[0].shaft(), joints_[1].shaft(), joints_[2].shaft()};
}

Eigen::Vector3d ArmSimulator::grip_point() const {
  return robot::grip_point(truth_, shafts());
}

double ArmSimulator::largest_sweep(const Eigen::Vector3d& goal) const {
  const Eigen::Vector3d start = path_.front();
  const Eigen::Vector3d along = (goal - start).normalized();
  double largest = 0.0;
  for (const auto& p : path_) {
    const Eigen::Vector3d off = (p - start) - along * (p - start).dot(along);
    largest = std::max(largest, off.norm());
  }
  return largest;
}

Eigen::Vector3d ArmSimulator::noise() {
  std::normal_distribution<double> normal(0.0, settings_.vision_sigma);
  const double x = normal(random_);
  const double y = normal(random_);
  return {x, y, normal(random_)};
}

}  // namespace markservo::visual_servo::test
