// Marks in full view and behind something nearer, through the real detector and locator: the covariance tells the
// truth. scripts/experiment hidden asks the same of a thousand draws.

#include <gtest/gtest.h>

#include <string>

#include "tests/scenes/hidden_marks.hpp"

namespace markservo::scenes {
namespace {

constexpr int kDraws = 60;
constexpr unsigned kSeed = 20000;

Consistency consistency(Hiding hiding) {
  const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return consistency_of(draw_hidden_marks(robot, hiding, kDraws, kSeed, {}));
}

void record(const Consistency& result) {
  testing::Test::RecordProperty("located", result.located);
  testing::Test::RecordProperty("within_chi_square_99", std::to_string(result.within));
  testing::Test::RecordProperty("mean_nees", std::to_string(result.mean_nees));
  testing::Test::RecordProperty("median_worst_sigma_mm", std::to_string(1e3 * result.median_worst_sigma));
}

// Two of 60 may lie beyond what one in a hundred does; the mean of 60 scatters by a third of one.
void expect_consistent(const Consistency& result) {
  EXPECT_GE(result.within * result.located, result.located - 2.0);
  EXPECT_GT(result.mean_nees, 1.3);
  EXPECT_LT(result.mean_nees, 4.5);
  EXPECT_LT(result.median_worst_sigma, 1.5e-3);
}

TEST(HiddenMarks, AreAllLocatedInFullViewAndAsWellAsTheyClaim) {
  const Consistency result = consistency(Hiding::kNothing);
  record(result);
  EXPECT_EQ(result.located, kDraws);
  expect_consistent(result);
}

TEST(HiddenMarks, ArePlacedByWhatIsSeenOfThemAsWellAsTheyClaim) {
  const Consistency result = consistency(Hiding::kPartly);
  record(result);
  EXPECT_GE(result.located, 0.9 * result.detected);
  EXPECT_GE(result.located, kDraws / 2);
  expect_consistent(result);
  EXPECT_LT(result.median_error, 0.15e-3);
}

TEST(HiddenMarks, AreHiddenAsMuchAsWasAskedForInTheViewThatShowsLess) {
  const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  HidingParameters parameters;
  parameters.share_min = parameters.share_max = 0.3;
  for (const HiddenMarkDraw& draw : draw_hidden_marks(robot, Hiding::kPartly, 6, kSeed, parameters)) {
    EXPECT_NEAR(std::max(draw.hidden_left, draw.hidden_right), 0.3, 0.04) << draw.seed;
  }
}

}  // namespace
}  // namespace markservo::scenes
