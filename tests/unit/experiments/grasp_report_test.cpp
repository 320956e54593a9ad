#include "tests/experiments/grasp_report.hpp"

#include <gtest/gtest.h>

namespace markservo::experiments {
namespace {

// A cell whose trials ended so far from their goal along x (m), each after so many frames of servoing.
std::vector<GraspCell> cells_with(const std::vector<double>& errors, int frames) {
  GraspCell cell;
  for (const double error : errors) {
    GraspTrial trial;
    trial.aim.error = Eigen::Vector3d(error, 0.0, 0.0);
    trial.aim.frames = frames;
    cell.trials.push_back(trial);
  }
  return {cell};
}

bool aim_is_met(const std::vector<GraspCell>& cells) {
  return print_aim(summarise_aim(cells));
}

TEST(Aim, IsMetByASmallError) {
  EXPECT_TRUE(aim_is_met(cells_with({0.0004, -0.0003, 0.0005}, 20)));
}

TEST(Aim, IsMissedByTheMeanByTheWorstOrByItsFrames) {
  EXPECT_FALSE(aim_is_met(cells_with({0.0006, 0.0006, 0.0006}, 20)));
  EXPECT_FALSE(aim_is_met(cells_with({0.0001, 0.0001, 0.0009}, 20)));
  EXPECT_FALSE(aim_is_met(cells_with({0.0001, 0.0001, 0.0001}, 40)));
}

TEST(Aim, IsNotMetWhereNothingWasGripped) {
  GraspCell cell;
  cell.trials.resize(2);
  EXPECT_EQ(summarise_aim({cell}).trials, 0);
  EXPECT_FALSE(aim_is_met({cell}));
}

TEST(Aim, KeepsTheSideToWhichTheGripIsOff) {
  const AimSummary aim = summarise_aim(cells_with({0.0004, -0.0002}, 20));
  EXPECT_NEAR(aim.error_bias.x(), 0.0001, 1e-12);
  EXPECT_NEAR(aim.error_mean, 0.0003, 1e-12);
}

}  // namespace
}  // namespace markservo::experiments
