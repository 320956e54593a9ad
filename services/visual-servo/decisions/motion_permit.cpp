#include "services/visual-servo/decisions/motion_permit.hpp"

namespace markservo::visual_servo {

void MotionPermit::observe_stop(bool latched, const std::string& reason) {
  latched_ = latched;
  reason_ = reason;
}

std::string MotionPermit::why_stopped() const {
  if (!latched_) return "no STOP_STATE of the arm yet";
  if (!*latched_) return "";
  return reason_.empty() ? "STOP is latched" : reason_;
}

}  // namespace markservo::visual_servo
