#include "services/visual-servo/arm/gripper_command.hpp"

#include <algorithm>

namespace markservo::visual_servo {

void GripperCommand::observe(const JointSample& sample, bool obeying) {
  watch_gripper(sample, opening_, since_, obeying, watch_);
}

void GripperCommand::adopt(const robot::GripperDescription& gripper, const JointSample& now) {
  if (!begun_) {
    begun_ = true;
    set_opening(gripper, now.contact ? 0.0 : now.gripper_opening, now.utime);
    force_ = gripper.force_max;
    return;
  }
  const bool holds = watch_.pressing || (now.contact && opening_ < now.gripper_opening);
  if (!holds) set_opening(gripper, now.gripper_opening, now.utime);
}

void GripperCommand::follow(const robot::GripperDescription& gripper, const Goal& goal, std::int64_t now) {
  set_opening(gripper, goal.gripper_opening, now);
  force_ = std::clamp(goal.gripper_force, 0.0, gripper.force_max);
}

void GripperCommand::set_opening(const robot::GripperDescription& gripper, double opening, std::int64_t now) {
  const double allowed = std::clamp(opening, 0.0, gripper.opening_max);
  if (allowed == opening_) return;
  opening_ = allowed;
  since_ = now;
}

}  // namespace markservo::visual_servo
