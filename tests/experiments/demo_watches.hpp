#pragma once

// What the demo's referee watches while a task runs: the lift and the carried book by the simulator's truth, motion
// that no command justifies, and how long commands take.

#include <chrono>
#include <cstdint>
#include <deque>
#include <markservo/JointCommand.hpp>
#include <markservo/SimTruth.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.hpp"
#include "tests/experiments/lift_truth.hpp"

namespace markservo::experiments {

// STEREO_FRAME heard to JOINT_COMMAND heard, by this process's clock.
class CommandLatency {
 public:
  explicit CommandLatency(bus::Bus& bus);
  void frame(std::int64_t seq);
  const std::vector<double>& milliseconds() const { return milliseconds_; }

 private:
  void note(const JointCommand& command);
  std::deque<std::pair<std::int64_t, std::chrono::steady_clock::time_point>> frames_;
  std::vector<double> milliseconds_;
};

// How long the target is held free in the air without a break, counted from the end of the lift (the first frame of
// CARRY or HOLD_LIFTED) and before it is put down.
class LiftWatch {
 public:
  // `state` as in TaskState.
  void observe(const SimTruth& truth, const std::string& target, std::int8_t state);
  double held() const { return held_; }        // s
  double highest() const { return highest_; }  // m

 private:
  std::optional<std::int64_t> since_;
  bool over_ = false;
  double held_ = 0.0;
  double highest_ = 0.0;
};

// How a carried book stands in the end.
struct CarriedBook {
  bool released = false;  // no finger touches it
  bool still = false;
  double tilt_deg = 0.0;          // from how it stood at first
  double displacement = 0.0;      // m, horizontally from its old place
  bool stands_elsewhere = false;  // released, still, upright, and not on its old place
};

// `before`: at the task's start; `earlier`, `last`: two looks at the end, apart in time. `spacing`: m, between books.
CarriedBook judge_carried(const SimBody& before, const SimBody& earlier, const SimBody& last, double spacing);

// How far the arm moved while no fresh command could have told it to: nothing but rest is safe there.
class StaleMotionWatch {
 public:
  explicit StaleMotionWatch(bus::Bus& bus);
  // `phase`: the task's state when the truth was heard.
  void observe(const SimTruth& truth, std::int8_t phase);
  double moved() const { return moved_; }      // rad, of the farthest joint
  double longest() const { return longest_; }  // s, without a fresh command while the world ran
  // The task's state during that time; nothing before the first observation.
  std::optional<std::int8_t> phase() const { return longest_phase_; }

 private:
  void note(const JointCommand& command);
  void note_gap(std::int64_t until_utime);

  std::int64_t world_session_ = 0;
  std::int64_t now_ = 0;           // us, the world's, at 100 Hz by JOINT_STATE
  std::int64_t last_command_ = 0;  // us, the world's time when it was heard
  std::int64_t answered_session_ = 0;
  std::int64_t answered_seq_ = 0;
  std::optional<std::int8_t> phase_;
  std::optional<std::int8_t> longest_phase_;
  std::int64_t truth_session_ = 0;
  bool was_stale_ = false;
  std::vector<double> shaft_;  // rad, where it was when the input became stale
  double moved_ = 0.0;
  double longest_ = 0.0;
};

// The largest difference, rad; infinite when the joints are not the same ones.
double farthest_joint(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace markservo::experiments
