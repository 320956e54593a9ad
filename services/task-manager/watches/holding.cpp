#include "services/task-manager/watches/holding.hpp"

namespace markservo::task_manager {

void Holding::grip(const ArmReport& arm, double object_width) {
  something_ = true;
  over_place_ = true;
  let_go_ = false;
  object_width_ = object_width;
  arm_session_ = arm.session;
  q_ = arm.q;
}

void Holding::observe_command(double opening) {
  if (something_) let_go_ = opening > object_width_;
}

bool Holding::too_wide(const ArmReport& arm) const {
  constexpr double kOpened = 0.006;  // m wider than the object: the hand does not hold it
  return arm.gripper_opening > object_width_ + kOpened;
}

bool Holding::holds_on(const std::optional<ArmReport>& arm) const {
  if (!something_ || let_go_) return false;
  return !arm || (arm->session == arm_session_ && !too_wide(*arm));
}

bool Holding::loses(const std::optional<ArmReport>& arm, bool at_work) {
  constexpr double kElsewhere = 0.2;  // rad: more than an arm coasts after a stop
  if (!something_ || !arm) return false;
  if (at_work) {
    q_ = arm->q;
    return false;
  }
  const bool lost = arm->session != arm_session_ || (arm->q - q_).cwiseAbs().maxCoeff() > kElsewhere || too_wide(*arm);
  if (lost) something_ = false;
  return lost;
}

}  // namespace markservo::task_manager
