// The rules of what the arm and who moves it say to each other.

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <vector>

#include "common/messages/covariance_rule.hpp"
#include "common/messages/vector_rule.hpp"

namespace markservo::messages {
namespace {

std::string joints_violation(std::int32_t num_joints, std::initializer_list<const std::vector<double>*> vectors) {
  constexpr std::int32_t kMaxJoints = 16;
  if (num_joints < 0 || num_joints > kMaxJoints) return wrong("num_joints", num_joints, "0 to 16");
  for (const auto* vector : vectors) {
    if (!all_finite(*vector)) return not_finite("a joint's value");
    for (const double value : *vector) {
      if (std::abs(value) > kMaxAngle) return wrong("a joint's value", value, "-10000 to 10000 rad or rad/s");
    }
  }
  return {};
}

std::string not_negative(const char* field, double value, const char* allowed) {
  return std::isfinite(value) && value >= 0.0 ? "" : wrong(field, value, allowed);
}

std::string gripper_violation(double opening, double force) {
  if (auto why = not_negative("gripper_opening", opening, "0 m or more"); !why.empty()) return why;
  return not_negative("gripper_force", force, "0 N or more");
}

}  // namespace

std::string MessageRules<ServoGoal>::violation(const ServoGoal& goal) {
  if (auto why = text::violation("target", goal.target); !why.empty()) return why;
  if (auto why = enum_violation("kind", goal.kind, ServoGoal::SERVO); !why.empty()) return why;
  if (auto why = near_violation("p_TG_C", goal.p_TG_C); !why.empty()) return why;
  if (auto why = not_negative("tolerance", goal.tolerance, "0 m or more"); !why.empty()) return why;
  if (auto why = not_negative("speed", goal.speed, "0 m/s or more"); !why.empty()) return why;
  if (auto why = joints_violation(goal.num_joints, {&goal.position}); !why.empty()) return why;
  return gripper_violation(goal.gripper_opening, goal.gripper_force);
}

void MessageRules<ServoGoal>::clean_texts(ServoGoal& goal) {
  text::clean(goal.target);
}

std::string MessageRules<ServoStatus>::violation(const ServoStatus& status) {
  if (auto why = text::violation("reason", status.reason); !why.empty()) return why;
  if (auto why = enum_violation("state", status.state, ServoStatus::STOPPED); !why.empty()) return why;
  if (!finite(status.error_C)) return not_finite("error_C");
  return covariance_violation(status.covariance, kMaxCovariance);
}

void MessageRules<ServoStatus>::clean_texts(ServoStatus& status) {
  text::clean(status.reason);
}

std::string MessageRules<JointCommand>::violation(const JointCommand& command) {
  if (auto why = count_violation("joint_session", command.joint_session); !why.empty()) return why;
  if (auto why = joints_violation(command.num_joints, {&command.position, &command.speed_limit}); !why.empty()) {
    return why;
  }
  for (const double speed : command.speed_limit) {
    if (speed <= 0.0) return wrong("speed_limit", speed, "above 0 rad/s");
  }
  return gripper_violation(command.gripper_opening, command.gripper_force);
}

std::string MessageRules<JointState>::violation(const JointState& state) {
  if (auto why = joints_violation(state.num_joints, {&state.position, &state.speed}); !why.empty()) return why;
  return gripper_violation(state.gripper_opening, 0.0);
}

}  // namespace markservo::messages
