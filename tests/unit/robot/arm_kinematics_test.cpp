#include "common/robot/arm_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::robot {
namespace {

constexpr double kDegree = geometry::radians(1.0);

class ArmKinematics : public ::testing::Test {
 protected:
  ArmDescription arm_ = *load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml").arm;
};

TEST_F(ArmKinematics, StretchedForwardTheGripPointIsTwoLinksAhead) {
  const Eigen::Vector3d p_AG = grip_point(arm_, {0.0, 0.0, 0.0}) - arm_.p_CA;
  EXPECT_TRUE(p_AG.isApprox(Eigen::Vector3d(0.0, 0.40, 0.15), 1e-12)) << p_AG.transpose();
}

TEST_F(ArmKinematics, PositiveYawTurnsLeftAndPositivePitchesRaise) {
  const JointVector q(0.0, 80.0 * kDegree, -60.0 * kDegree);
  const Eigen::Vector3d p_CG = grip_point(arm_, q);
  EXPECT_LT(grip_point(arm_, q + JointVector(0.1, 0.0, 0.0)).x(), p_CG.x());
  EXPECT_GT(grip_point(arm_, q + JointVector(0.0, 0.0, 0.1)).z(), p_CG.z());
}

TEST_F(ArmKinematics, JacobianAgreesWithDifferences) {
  arm_.yaw_CA = 0.1;
  const JointVector q(0.2, 1.3, -0.9);
  const Eigen::Matrix3d jacobian = grip_point_jacobian(arm_, q);
  constexpr double kStep = 1e-6;  // rad
  for (int joint = 0; joint < kNumJoints; ++joint) {
    const JointVector step = kStep * JointVector::Unit(joint);
    const Eigen::Vector3d numeric = (grip_point(arm_, q + step) - grip_point(arm_, q - step)) / (2.0 * kStep);
    EXPECT_TRUE(jacobian.col(joint).isApprox(numeric, 1e-6)) << "joint " << joint;
  }
}

TEST_F(ArmKinematics, InverseBringsTheGripPointBackElbowUp) {
  int reachable = 0;
  for (double x = -0.10; x <= 0.15; x += 0.05) {
    for (double y = 0.15; y <= 0.35; y += 0.05) {
      for (double z = -0.10; z <= 0.05; z += 0.05) {
        const auto ik = inverse_kinematics(arm_, {x, y, z}, 0.0);
        if (ik.status != ReachStatus::kReachable) continue;
        ++reachable;
        EXPECT_LE(ik.q[2], 0.0);
        EXPECT_TRUE(grip_point(arm_, ik.q).isApprox(Eigen::Vector3d(x, y, z), 1e-9));
      }
    }
  }
  EXPECT_GT(reachable, 60);
}

TEST_F(ArmKinematics, InverseSaysWhyNot) {
  EXPECT_EQ(inverse_kinematics(arm_, {0.0325, 0.80, 0.0}, 0.0).status, ReachStatus::kTooFar);
  EXPECT_EQ(inverse_kinematics(arm_, arm_.p_CA + Eigen::Vector3d(0.0, -0.20, 0.20), 0.0).status,
            ReachStatus::kYawLimit);
  // Just inside the stretched arm, but not by the margin.
  const Eigen::Vector3d stretched = grip_point(arm_, {0.0, 0.5, 0.0});
  const Eigen::Vector3d a_little_back = stretched - 1e-5 * (stretched - arm_.p_CA).normalized();
  EXPECT_EQ(inverse_kinematics(arm_, a_little_back, 0.0).status, ReachStatus::kReachable);
  EXPECT_EQ(inverse_kinematics(arm_, a_little_back, 5.0 * kDegree).status, ReachStatus::kTooFar);
}

TEST_F(ArmKinematics, SaysWithNumbersWhyThereIsNoInverse) {
  EXPECT_EQ(why_unreachable(arm_, {0.0325, 0.30, 0.0}, 0.0), "");
  arm_.forearm = 0.15;
  const Eigen::Vector3d p_CS = arm_.p_CA + Eigen::Vector3d(0.0, 0.0, arm_.column);
  EXPECT_EQ(why_unreachable(arm_, p_CS + Eigen::Vector3d(0.0, 0.5, 0.0), 90.0 * kDegree),
            "beyond the arm's reach: 0.500 m from the shoulder; allowed: 0.050 to 0.250 m");
  EXPECT_EQ(why_unreachable(arm_, p_CS + Eigen::Vector3d(0.0, 0.0, 0.03), 0.0),
            "too close to the arm's column: 0.030 m from the shoulder; allowed: 0.050 to 0.350 m");
  EXPECT_EQ(why_unreachable(arm_, grip_point(arm_, {100.0 * kDegree, 0.5, -0.5}), 5.0 * kDegree),
            "beyond the yaw joint's limit: 100.0 degrees; allowed: -85.0 to 85.0 degrees");
  EXPECT_EQ(why_unreachable(arm_, grip_point(arm_, {0.0, -10.0 * kDegree, -0.5}), 5.0 * kDegree),
            "beyond the shoulder joint's limit: -10.0 degrees; allowed: 0.0 to 155.0 degrees");
  EXPECT_EQ(why_unreachable(arm_, grip_point(arm_, {0.0, 100.0 * kDegree, -158.0 * kDegree}), 5.0 * kDegree),
            "beyond the elbow joint's limit: -158.0 degrees; allowed: -155.0 to -5.0 degrees");
}

TEST_F(ArmKinematics, HandMarkTurnsWithTheForearm) {
  // Grip point minus hand mark changes with the yaw: why no constant offset serves the workspace.
  const auto offset = [&](double x) {
    const auto ik = inverse_kinematics(arm_, {x, 0.26, -0.02}, 0.0);
    return Eigen::Vector3d(hand_mark(arm_, ik.q) - grip_point(arm_, ik.q));
  };
  EXPECT_GT((offset(0.10) - offset(0.0325)).norm(), 0.010);
}

TEST_F(ArmKinematics, HandMarkFacesTheCameras) {
  const auto ik = inverse_kinematics(arm_, {0.0325, 0.265, -0.02}, 0.0);
  const Eigen::Vector3d printed_side = -hand_mark_pose(arm_, ik.q).linear().col(1);
  EXPECT_LT(printed_side.y(), -0.95);
}

}  // namespace
}  // namespace markservo::robot
