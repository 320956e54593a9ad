#pragma once

#include <optional>

#include "services/rfid-localizer/free_motion.hpp"
#include "services/rfid-localizer/wheel_motion.hpp"

namespace markservo::rfid_localizer {

// Both ways to tell how the robot moves, and which one holds: at first inertia.
class MotionChoice {
 public:
  // `history` must outlive this.
  MotionChoice(const WheelHistory& history, const Eigen::Vector2d& p_RF, const WheelMotionParameters& wheels,
               const FreeMotionParameters& free)
      : wheels_(history, p_RF, wheels), free_(p_RF, free) {}

  bool by_wheels() const { return by_wheels_; }
  void choose(bool by_wheels) { by_wheels_ = by_wheels; }

  const Motion& now() const { return of(by_wheels_); }
  const Motion& of(bool by_wheels) const { return by_wheels ? static_cast<const Motion&>(wheels_) : free_; }

  // As WheelMotionModel's.
  void set_heading(const std::optional<HeadingPrior>& heading) { wheels_.set_heading(heading); }

 private:
  WheelMotionModel wheels_;
  FreeMotionModel free_;
  bool by_wheels_ = false;
};

}  // namespace markservo::rfid_localizer
