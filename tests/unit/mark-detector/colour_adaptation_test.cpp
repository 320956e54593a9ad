// The detector keeps its marks while the light changes: few sequences of what scripts/experiment light runs many of.

#include <gtest/gtest.h>

#include <string>

#include "tests/light/light_trial.hpp"

namespace markservo::light {
namespace {

constexpr double kSigma = 3.0;
constexpr unsigned kSeed = 2;

robot::RobotDescription small_robot() {
  robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  // A quarter of the pixels is enough, and quicker.
  robot::CameraDescription& cameras = robot.cameras;
  cameras.width /= 2;
  cameras.height /= 2;
  geometry::StereoCamera& stereo = cameras.stereo;
  stereo.fx *= 0.5;
  stereo.fy *= 0.5;
  for (double* centre : {&stereo.cx_left, &stereo.cx_right, &stereo.cy}) *centre = 0.5 * (*centre + 0.5) - 0.5;
  return robot;
}

class ChangingLight : public ::testing::TestWithParam<std::string> {
 protected:
  static void SetUpTestSuite() {
    robot_ = new robot::RobotDescription(small_robot());
    scene_ = new LightScene(robot_->cameras, robot_->marks, kSigma, kSeed);
  }
  static void TearDownTestSuite() {
    delete scene_;
    delete robot_;
  }
  static Trial run(const std::string& kind, bool adapt) {
    constexpr int kNumFrames = 66;
    mark_detector::Parameters parameters;
    parameters.adapt = adapt;
    return run_trial(*scene_, light_sequence(kind, kNumFrames, kSeed), robot_->marks, parameters);
  }

  static robot::RobotDescription* robot_;
  static LightScene* scene_;
};
robot::RobotDescription* ChangingLight::robot_ = nullptr;
LightScene* ChangingLight::scene_ = nullptr;

TEST_P(ChangingLight, LosesNoMarkForMoreThanThreeFramesAndConfusesNone) {
  for (const MarkScore& score : run(GetParam(), true).marks) {
    EXPECT_GT(score.visible, 0) << score.mark;
    EXPECT_LE(score.longest_lost, 3) << score.mark;
    EXPECT_EQ(score.confused, 0) << score.mark;
    EXPECT_GT(score.least_separability, 0.5) << score.mark;
  }
}

INSTANTIATE_TEST_SUITE_P(OfKind, ChangingLight, ::testing::ValuesIn(light_kinds()),
                         [](const auto& kind) { return kind.param; });

class WithoutAdapting : public ChangingLight {};
TEST_F(WithoutAdapting, MarksAreLostWhereCastsAreAtTheirLimits) {
  int longest_lost = 0;
  for (const MarkScore& score : run("corners", false).marks) longest_lost = std::max(longest_lost, score.longest_lost);
  EXPECT_GT(longest_lost, 3) << "else the sequences ask nothing of adapting";
}

}  // namespace
}  // namespace markservo::light
