#include "tests/experiments/demo_watches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <markservo/JointState.hpp>
#include <markservo/TaskState.hpp>

#include "common/geometry/plane_pose.hpp"

namespace markservo::experiments {
namespace {

constexpr std::size_t kRememberedFrames = 32;
// The arm's own watchdog holds it after 0.3 s without a command; then it needs a moment to come to rest.
constexpr std::int64_t kStale_us = 350'000;
constexpr double kStill = 0.0005;     // m
constexpr double kUprightTilt = 3.0;  // deg

double seconds(std::int64_t utime) {
  return 1e-6 * static_cast<double>(utime);
}

Eigen::Quaterniond orientation(const SimBody& body) {
  return {body.q_CB_w, body.q_CB_x, body.q_CB_y, body.q_CB_z};
}

}  // namespace

CommandLatency::CommandLatency(bus::Bus& bus) {
  bus.on_each(channels::kJointCommand, [this](const JointCommand& command) { note(command); });
}

void CommandLatency::frame(std::int64_t seq) {
  frames_.emplace_back(seq, std::chrono::steady_clock::now());
  if (frames_.size() > kRememberedFrames) frames_.pop_front();
}

void CommandLatency::note(const JointCommand& command) {
  for (const auto& [seq, when] : frames_) {
    if (seq != command.frame_seq) continue;
    milliseconds_.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - when).count());
  }
}

void LiftWatch::observe(const SimTruth& truth, const std::string& target, std::int8_t state) {
  const SimBody* body = find_body(truth, target);
  if (body == nullptr) return;
  if (state == TaskState::LIFT) *this = LiftWatch();  // another attempt counts alone
  if (state >= TaskState::LIFT) highest_ = std::max(highest_, body->height_gain);
  if (state != TaskState::CARRY && state != TaskState::HOLD_LIFTED) {
    if (since_) over_ = true;
    return;
  }
  if (!held_free(*body)) over_ = true;
  if (over_) return;
  if (!since_) since_ = truth.utime;
  held_ = seconds(truth.utime - *since_);
}

CarriedBook judge_carried(const SimBody& before, const SimBody& earlier, const SimBody& last, double spacing) {
  CarriedBook book;
  book.released = !last.touches_left_finger && !last.touches_right_finger;
  book.still = (vector(last.p_CB) - vector(earlier.p_CB)).norm() < kStill;
  const Eigen::Vector3d up = orientation(before).conjugate() * Eigen::Vector3d::UnitZ();
  const double cosine = std::clamp((orientation(last) * up).z(), -1.0, 1.0);
  book.tilt_deg = geometry::degrees(std::acos(cosine));
  book.displacement = (vector(last.p_CB) - vector(before.p_CB)).head<2>().norm();
  book.stands_elsewhere = book.released && book.still && book.tilt_deg < kUprightTilt && book.displacement > spacing;
  return book;
}

StaleMotionWatch::StaleMotionWatch(bus::Bus& bus) {
  bus.on_each(channels::kJointState, [this](const JointState& joints) {
    if (joints.session != world_session_) last_command_ = joints.utime;  // another world, another time
    world_session_ = joints.session;
    now_ = joints.utime;
  });
  bus.on_each(channels::kJointCommand, [this](const JointCommand& command) { note(command); });
}

void StaleMotionWatch::note(const JointCommand& command) {
  if (command.frame_session == answered_session_ && command.frame_seq <= answered_seq_) return;
  answered_session_ = command.frame_session;
  answered_seq_ = command.frame_seq;
  note_gap(now_);
  last_command_ = now_;
}

void StaleMotionWatch::note_gap(std::int64_t until_utime) {
  const double gap = seconds(until_utime - last_command_);
  if (!phase_ || gap <= longest_) return;
  longest_ = gap;
  longest_phase_ = phase_;
}

void StaleMotionWatch::observe(const SimTruth& truth, std::int8_t phase) {
  if (!phase_) last_command_ = std::max(last_command_, truth.utime);  // what was before the task is not judged
  phase_ = phase;
  const bool same_world = truth.session == truth_session_ && shaft_.size() == truth.shaft.size();
  truth_session_ = truth.session;
  if (truth.session == world_session_) note_gap(truth.utime);
  const bool stale = same_world && truth.utime - last_command_ > kStale_us;
  if (stale && was_stale_) {
    moved_ = std::max(moved_, farthest_joint(truth.shaft, shaft_));
  } else {
    shaft_ = truth.shaft;
  }
  was_stale_ = stale;
}

double farthest_joint(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, std::abs(a[i] - b[i]));
  return farthest;
}

}  // namespace markservo::experiments
