#include "services/task-manager/watches/lift_check.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

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
                       const LiftDemand& demand) {
  const Eigen::Isometry3d way = robot::grip_pose(arm, after.q) * robot::grip_pose(arm, before.q).inverse();
  const Eigen::Quaterniond turn(way.linear());
  const Eigen::Vector3d p_CG = robot::grip_point(arm, before.q);
  const Eigen::Vector3d p_CG_after = after.p_CM + turn * (p_CG - before.p_CM);

  // Two pads hold an object like a hinge: where the target's mark is if it hung, and if it turned with the hand.
  const Eigen::Vector3d p_GT = before.p_CT - p_CG;
  const Eigen::Vector3d hung = p_CG_after + p_GT;
  const Eigen::Vector3d arc = p_CG_after + turn * p_GT - hung;
  const double share = arc.norm() > 0.0 ? std::clamp((after.p_CT - hung).dot(arc) / arc.squaredNorm(), 0.0, 1.0) : 0.0;
  const Eigen::Vector3d expected = p_CG_after + Eigen::Quaterniond::Identity().slerp(share, turn) * p_GT;

  LiftVerdict verdict;
  verdict.error = after.p_CT - expected;
  const double joints_rise = robot::grip_point(arm, after.q).z() - robot::grip_point(arm, before.q).z();
  const double hand_rise = after.p_CM.z() - before.p_CM.z();
  const double target_rise = after.p_CT.z() - before.p_CT.z();
  const double hand_predicted = (way * before.p_CM).z() - before.p_CM.z();
  const double target_predicted = (way.linear() * p_GT).z() + robot::grip_point(arm, after.q).z() - before.p_CT.z();
  const bool rose = joints_rise >= demand.rise_share * demand.height &&
                    hand_rise >= demand.rise_share * hand_predicted &&
                    target_rise >= demand.rise_share * target_predicted;
  verdict.came_along = rose && verdict.error.norm() <= demand.tolerance;
  verdict.reason = fmt::format(
      "the hand's mark rose by {:.1f} mm of {:.1f} mm, the target's by {:.1f} mm of {:.1f} mm, {:.1f} mm off its way",
      1000.0 * hand_rise, 1000.0 * hand_predicted, 1000.0 * target_rise, 1000.0 * target_predicted,
      1000.0 * verdict.error.norm());
  return verdict;
}

}  // namespace markservo::task_manager
