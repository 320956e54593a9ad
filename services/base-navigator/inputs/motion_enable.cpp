#include "services/base-navigator/inputs/motion_enable.hpp"

namespace markservo::base_navigator {

void MotionEnable::observe_stop(bool latched, const std::string& reason) {
  latched_ = latched;
  stop_reason_ = reason;
}

std::string MotionEnable::why_stopped() const {
  if (!conflict_.empty()) return conflict_;
  if (!latched_) return "no STOP_STATE of the base yet";
  if (!*latched_) return "";
  return stop_reason_.empty() ? "STOP is latched" : stop_reason_;
}

}  // namespace markservo::base_navigator
