#pragma once

// What a TARGET_POSE says of one mark.

#include <string>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

// The mark of that name, or null.
inline const MarkSample* find(const PoseSample& pose, const std::string& name) {
  for (const auto& mark : pose.marks) {
    if (mark.name == name) return &mark;
  }
  return nullptr;
}

// Why the mark cannot be used; empty when it can.
inline std::string why_lost(const MarkSample* mark, const std::string& name) {
  if (mark == nullptr) return "TARGET_POSE does not list mark " + name;
  if (!mark->located) return "mark " + name + ": " + (mark->problem.empty() ? "not located" : mark->problem);
  if (!mark->p_C.allFinite() || !mark->covariance.allFinite()) return "mark " + name + ": position is not finite";
  return "";
}

}  // namespace markservo::visual_servo
