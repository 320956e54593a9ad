#include "tests/experiments/aim_watch.hpp"

#include <gtest/gtest.h>

namespace markservo::experiments {
namespace {

const Eigen::Vector3d kTarget(0.03, 0.25, 0.03);      // m
const Eigen::Vector3d kGripPoint(0.0, 0.015, -0.05);  // m, from the target

SimTruth truth_with_error(const Eigen::Vector3d& error) {
  SimTruth truth{};
  const Eigen::Vector3d p_CG = kTarget + kGripPoint + error;
  truth.p_CG.x = p_CG.x();
  truth.p_CG.y = p_CG.y();
  truth.p_CG.z = p_CG.z();
  truth.marks.resize(1);
  truth.marks[0].name = "red_book";
  truth.marks[0].p_C.x = kTarget.x();
  truth.marks[0].p_C.y = kTarget.y();
  truth.marks[0].p_C.z = kTarget.z();
  truth.num_marks = 1;
  return truth;
}

class AimWatchOfATask : public testing::Test {
 protected:
  void frame(std::int8_t state, double error_x) { watch_.observe(truth_with_error({error_x, 0.0, 0.0}), state); }

  AimWatch watch_{"red_book", kGripPoint};
};

TEST_F(AimWatchOfATask, TakesTheErrorAtTheFirstFrameOfTheGrip) {
  frame(TaskState::SERVO, 0.010);
  EXPECT_FALSE(watch_.aim().error);
  frame(TaskState::SERVO, 0.002);
  frame(TaskState::GRIP, 0.001);
  frame(TaskState::GRIP, 0.004);  // the closing fingers draw the hand along
  frame(TaskState::LIFT, 0.004);
  EXPECT_NEAR(watch_.aim().error.value().x(), 0.001, 1e-12);
  EXPECT_EQ(watch_.aim().frames, 2);
}

TEST_F(AimWatchOfATask, JudgesTheLastAttemptAlone) {
  frame(TaskState::SERVO, 0.002);
  frame(TaskState::GRIP, 0.002);
  frame(TaskState::APPROACH, 0.1);
  EXPECT_FALSE(watch_.aim().error);
  frame(TaskState::SERVO, 0.002);
  frame(TaskState::GRIP, 0.0005);
  EXPECT_NEAR(watch_.aim().error.value().x(), 0.0005, 1e-12);
  EXPECT_EQ(watch_.aim().frames, 1);
}

TEST_F(AimWatchOfATask, KnowsNothingOfAHandThatDidNotGrip) {
  frame(TaskState::SERVO, 0.002);
  frame(TaskState::FAILED, 0.001);
  EXPECT_FALSE(watch_.aim().error);
}

}  // namespace
}  // namespace markservo::experiments
