#include "services/task-manager/plans/posture_path.hpp"

#include <gtest/gtest.h>

#include "tests/unit/task-manager/fake_robot.hpp"

namespace markservo::task_manager {
namespace {

constexpr double kMargin = 0.09;  // rad
const Eigen::Vector3d kBeforeTheShelf(0.0325, 0.20, 0.0);
const Eigen::Vector3d kTooFar(0.0325, 0.60, 0.0);

PosturePath path_from(const robot::ArmDescription& arm, const Eigen::Vector3d& p_CG) {
  return {arm, robot::inverse_kinematics(arm, p_CG, kMargin).q, 0.05, kMargin};
}

TEST(PosturePath, TellsWithNumbersWhyItsFirstPointOutOfReachIsOne) {
  const auto robot = default_robot();
  PosturePath path = path_from(*robot.arm, kBeforeTheShelf);
  path.line_to(kTooFar, 0.001, 0.1);
  EXPECT_FALSE(path.reachable());
  const std::string why = path.trouble();
  const Eigen::Vector3d next = path.end_point() + Eigen::Vector3d(0.0, 0.001, 0.0);
  EXPECT_EQ(why, robot::why_unreachable(*robot.arm, next, kMargin)) << "1 mm beyond the last that is reached";
  const std::size_t moves = path.moves().size();
  path.turn_to(10.0, 0.1);
  path.line_to(-kTooFar, 0.01, 0.1);
  EXPECT_EQ(path.trouble(), why) << "what comes after it does not matter";
  EXPECT_EQ(path.moves().size(), moves);
}

TEST(PosturePath, TellsHowFarItMayTurn) {
  const auto robot = default_robot();
  PosturePath path = path_from(*robot.arm, kBeforeTheShelf);
  path.turn_to(geometry::radians(100.0), 0.1);
  EXPECT_EQ(path.trouble(), "beyond the yaw joint's limit: 100.0 degrees; allowed: -90.0 to 90.0 degrees");
}

TEST(PosturePath, HasNoTroubleWithinReach) {
  const auto robot = default_robot();
  PosturePath path = path_from(*robot.arm, kBeforeTheShelf);
  path.line_to(kBeforeTheShelf + Eigen::Vector3d(0.0, 0.05, 0.0), 0.01, 0.1);
  path.turn_to(0.5, 0.1);
  EXPECT_TRUE(path.reachable());
  EXPECT_EQ(path.trouble(), "");
}

}  // namespace
}  // namespace markservo::task_manager
