#include "services/task-manager/lift_check.hpp"

#include <cstdio>

#include "common/robot/arm_kinematics.hpp"

namespace markservo::task_manager {

void MarkAverage::add(std::int64_t frame_utime, const Eigen::Vector3d& p_C) {
  if (count_ > 0 && frame_utime == last_utime_) return;
  last_utime_ = frame_utime;
  sum_ += p_C;
  ++count_;
}

Eigen::Vector3d MarkAverage::mean() const {
  if (count_ == 0) return Eigen::Vector3d::Zero();
  return sum_ / count_;
}

LiftVerdict check_lift(const robot::ArmDescription& arm, const LiftView& before, const LiftView& after,
                       double tolerance) {
  // The hand's turn between both postures, and where it takes the target's mark from the hand's.
  const Eigen::Matrix3d turn =
      robot::grip_pose(arm, after.q).linear() * robot::grip_pose(arm, before.q).linear().transpose();
  const Eigen::Vector3d expected = after.p_CM + turn * (before.p_CT - before.p_CM);

  LiftVerdict verdict;
  verdict.error = after.p_CT - expected;
  verdict.came_along = verdict.error.norm() <= tolerance;
  char text[160];
  std::snprintf(text, sizeof text, "the hand's mark rose by %.1f mm, the target's by %.1f mm, %.1f mm off its way",
                1000.0 * (after.p_CM.z() - before.p_CM.z()), 1000.0 * (after.p_CT.z() - before.p_CT.z()),
                1000.0 * verdict.error.norm());
  verdict.reason = text;
  return verdict;
}

}  // namespace markservo::task_manager
