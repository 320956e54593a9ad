#pragma once

#include <optional>

#include "services/rfid-localizer/belief.hpp"
#include "services/rfid-localizer/free_motion.hpp"
#include "services/rfid-localizer/wheel_judge.hpp"
#include "services/rfid-localizer/wheel_motion.hpp"

namespace markservo::rfid_localizer {

// Both ways to tell how the robot moves, and which one holds: at first inertia. The wheels are believed as far as the
// rounds bear out what is stated of them.
class MotionChoice {
 public:
  // `history` must outlive this.
  MotionChoice(const WheelHistory& history, const Eigen::Vector2d& p_RF, const WheelMotionParameters& wheels,
               const FreeMotionParameters& free, const std::optional<WheelJudgeParameters>& judge);

  bool by_wheels() const { return by_wheels_; }
  void choose(bool by_wheels);

  const Motion& now() const { return of(by_wheels_); }
  const Motion& of(bool by_wheels) const { return by_wheels ? static_cast<const Motion&>(wheels_) : free_; }

  // As WheelMotionModel's.
  void set_heading(const std::optional<HeadingPrior>& heading) { wheels_.set_heading(heading); }

  // Moves what is believed on to `to` (us), once for each part of the time.
  void predict(Belief& belief, std::int64_t to);
  // A round took the belief from `before` to `after`; `view` is the antenna's by `before`.
  void judge(const Hypothesis& before, const Hypothesis& after, const AntennaView& view);
  // The belief began anew.
  void restart_judging();
  WheelJudgement judgement() const;

 private:
  const WheelHistory& history_;
  WheelMotionModel wheels_;
  FreeMotionModel free_;
  std::optional<WheelJudge> judge_;
  bool by_wheels_ = false;
};

}  // namespace markservo::rfid_localizer
