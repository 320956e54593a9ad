#include "services/visual-servo/decisions/motion_enable.hpp"

namespace markservo::visual_servo {

void MotionEnable::observe_stop(bool latched, const std::string& reason) {
  latched_ = latched;
  reason_ = reason;
}

std::string MotionEnable::why_stopped() const {
  if (!latched_) return "no STOP_STATE of the arm yet";
  if (!*latched_) return "";
  return reason_.empty() ? "STOP is latched" : reason_;
}

}  // namespace markservo::visual_servo
