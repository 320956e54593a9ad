#include "common/robot/arm_kinematics.hpp"

#include <fmt/core.h>

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::robot {
namespace {

bool inside(const JointDescription& joint, double angle, double margin) {
  return angle >= joint.min + margin && angle <= joint.max - margin;
}

}  // namespace

Eigen::Isometry3d arm_base_pose(const ArmDescription& arm) {
  Eigen::Isometry3d X_CA = Eigen::Isometry3d::Identity();
  X_CA.linear() = Eigen::AngleAxisd(arm.yaw_CA, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  X_CA.translation() = arm.p_CA;
  return X_CA;
}

Eigen::Vector3d grip_point(const ArmDescription& arm, const JointVector& q) {
  return grip_pose(arm, q).translation();
}

Eigen::Isometry3d grip_pose(const ArmDescription& arm, const JointVector& q) {
  const double forearm_pitch = q[1] + q[2];
  const double radius = arm.upper_arm * std::cos(q[1]) + arm.forearm * std::cos(forearm_pitch);
  const double height = arm.column + arm.upper_arm * std::sin(q[1]) + arm.forearm * std::sin(forearm_pitch);
  Eigen::Isometry3d X_AG = Eigen::Isometry3d::Identity();
  X_AG.linear() =
      (Eigen::AngleAxisd(q[0], Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(forearm_pitch, Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  X_AG.translation() << -radius * std::sin(q[0]), radius * std::cos(q[0]), height;
  return arm_base_pose(arm) * X_AG;
}

Eigen::Vector3d hand_mark(const ArmDescription& arm, const JointVector& q) {
  return grip_pose(arm, q) * arm.p_GM;
}

Eigen::Isometry3d hand_mark_pose(const ArmDescription& arm, const JointVector& q) {
  Eigen::Isometry3d X_GM = Eigen::Isometry3d::Identity();
  X_GM.linear() = Eigen::AngleAxisd(-arm.hand_mark_tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
  X_GM.translation() = arm.p_GM;
  return grip_pose(arm, q) * X_GM;
}

Eigen::Matrix3d grip_point_jacobian(const ArmDescription& arm, const JointVector& q) {
  const double forearm_pitch = q[1] + q[2];
  const double radius = arm.upper_arm * std::cos(q[1]) + arm.forearm * std::cos(forearm_pitch);
  const double d_radius_1 = -arm.upper_arm * std::sin(q[1]) - arm.forearm * std::sin(forearm_pitch);
  const double d_radius_2 = -arm.forearm * std::sin(forearm_pitch);
  const double d_height_1 = arm.upper_arm * std::cos(q[1]) + arm.forearm * std::cos(forearm_pitch);
  const double d_height_2 = arm.forearm * std::cos(forearm_pitch);
  const double s = std::sin(q[0]);
  const double c = std::cos(q[0]);
  Eigen::Matrix3d J_A;
  J_A.col(0) << -radius * c, -radius * s, 0.0;
  J_A.col(1) << -d_radius_1 * s, d_radius_1 * c, d_height_1;
  J_A.col(2) << -d_radius_2 * s, d_radius_2 * c, d_height_2;
  return arm_base_pose(arm).linear() * J_A;
}

InverseKinematics inverse_kinematics(const ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin) {
  const Eigen::Vector3d p_AG = arm_base_pose(arm).inverse() * p_CG;
  const double radius = std::hypot(p_AG.x(), p_AG.y());
  const double height = p_AG.z() - arm.column;
  const double reach_squared = radius * radius + height * height;
  const double l1 = arm.upper_arm;
  const double l2 = arm.forearm;

  InverseKinematics result;
  const double cos_elbow = (reach_squared - l1 * l1 - l2 * l2) / (2.0 * l1 * l2);
  if (cos_elbow > std::cos(margin)) {
    result.status = ReachStatus::kTooFar;
    return result;
  }
  if (cos_elbow < -1.0) {
    result.status = ReachStatus::kTooClose;
    return result;
  }
  const double elbow = -std::acos(cos_elbow);
  const double shoulder = std::atan2(height, radius) - std::atan2(l2 * std::sin(elbow), l1 + l2 * std::cos(elbow));
  const double yaw = std::atan2(-p_AG.x(), p_AG.y());
  result.q << yaw, shoulder, elbow;
  if (!inside(arm.joints[0], yaw, margin)) {
    result.status = ReachStatus::kYawLimit;
  } else if (!inside(arm.joints[1], shoulder, margin)) {
    result.status = ReachStatus::kShoulderLimit;
  } else if (!inside(arm.joints[2], elbow, margin)) {
    result.status = ReachStatus::kElbowLimit;
  } else {
    result.status = ReachStatus::kReachable;
  }
  return result;
}

const char* describe(ReachStatus status) {
  switch (status) {
    case ReachStatus::kReachable:
      return "reachable";
    case ReachStatus::kTooFar:
      return "beyond the arm's reach";
    case ReachStatus::kTooClose:
      return "too close to the arm's column";
    case ReachStatus::kYawLimit:
      return "beyond the yaw joint's limit";
    case ReachStatus::kShoulderLimit:
      return "beyond the shoulder joint's limit";
    case ReachStatus::kElbowLimit:
      return "beyond the elbow joint's limit";
  }
  return "unknown";
}

std::string why_unreachable(const ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin) {
  const InverseKinematics ik = inverse_kinematics(arm, p_CG, margin);
  const auto beyond_limit = [&](std::size_t joint, double angle) {
    return fmt::format("{}: {:.1f} degrees; allowed: {:.1f} to {:.1f} degrees", describe(ik.status),
                       geometry::degrees(angle), geometry::degrees(arm.joints[joint].min + margin),
                       geometry::degrees(arm.joints[joint].max - margin));
  };
  switch (ik.status) {
    case ReachStatus::kTooFar:
    case ReachStatus::kTooClose: {
      const Eigen::Vector3d p_AG = arm_base_pose(arm).inverse() * p_CG;
      const Eigen::Vector3d p_AS(0.0, 0.0, arm.column);  // the shoulder
      const double least = std::abs(arm.upper_arm - arm.forearm);
      // The elbow is bent by the margin.
      const double most = std::hypot(arm.upper_arm + arm.forearm * std::cos(margin), arm.forearm * std::sin(margin));
      return fmt::format("{}: {:.3f} m from the shoulder; allowed: {:.3f} to {:.3f} m", describe(ik.status),
                         (p_AG - p_AS).norm(), least, most);
    }
    case ReachStatus::kYawLimit:
      return beyond_limit(0, ik.q[0]);
    case ReachStatus::kShoulderLimit:
      return beyond_limit(1, ik.q[1]);
    case ReachStatus::kElbowLimit:
      return beyond_limit(2, ik.q[2]);
    case ReachStatus::kReachable:
      break;
  }
  return {};
}

}  // namespace markservo::robot
