// What the laws are told, what they remember, and when they have arrived.

#include "services/visual-servo/laws/convergence.hpp"
#include "services/visual-servo/laws/law_state.hpp"
#include "services/visual-servo/laws/paper_law.hpp"
#include "services/visual-servo/sight/hand_and_target.hpp"
#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

TEST(Convergence, AimsFinerThanAskedWhileCorrectionsHelp) {
  const ConvergenceParameters parameters;
  EXPECT_EQ(judge(parameters, 0.001, 0, 0.0007, false), Verdict::kConverged);
  EXPECT_EQ(judge(parameters, 0.001, 0, 0.0011, false), Verdict::kOff);
  EXPECT_EQ(judge(parameters, 0.001, 4, 0.00099, false), Verdict::kConverged);
  EXPECT_EQ(judge(parameters, 0.010, 0, 0.0039, false), Verdict::kConverged) << "0.4 of a wide tolerance will do";
}

TEST(Convergence, LooksLongerWhereFewFramesCannotTell) {
  const ConvergenceParameters parameters;
  EXPECT_EQ(judge(parameters, 0.001, 0, 0.0008, false), Verdict::kInDoubt);
  EXPECT_EQ(judge(parameters, 0.001, 0, 0.0008, true), Verdict::kConverged);
  EXPECT_EQ(judge(parameters, 0.001, 0, 0.00095, true), Verdict::kOff);
  EXPECT_EQ(judge(parameters, 0.0005, 0, 0.0006, true), Verdict::kOff) << "never beyond the goal's tolerance";
}

TEST(Convergence, CorrectsWhatIsSurelyCoarserThanItsOwnAimThoughTheGoalAllowsIt) {
  const ConvergenceParameters parameters;
  for (const int corrections : {0, 1, parameters.fine_corrections - 1}) {
    EXPECT_EQ(judge(parameters, 0.0015, corrections, 0.00095, true), Verdict::kOff) << corrections;
  }
  EXPECT_EQ(judge(parameters, 0.0015, parameters.fine_corrections, 0.00095, true), Verdict::kConverged);
}

TEST(LawState, KeepsWhatItLearnedOfTheArmForAnotherGoalButNotOfAnotherArm) {
  const auto robot = the_robot();
  const JointVector q(0.3, 1.2, -1.2);
  const Eigen::Vector3d off(0.003, 0.0, 0.0);
  LawState state;
  state.sight.corrections = 3;
  for (int i = 0; i < 10; ++i) {
    state.sight.bias.observe(*robot.arm, {}, {q, JointVector::Zero(), JointVector::Zero()},
                             robot::hand_mark(*robot.arm, q) + off);
  }
  state.forget();
  EXPECT_EQ(state.sight.corrections, 0);
  EXPECT_LT((state.sight.bias.at(*robot.arm, q, JointVector::Zero()) - off).norm(), 0.0005);
  state.begin_anew();
  EXPECT_EQ(state.sight.bias.at(*robot.arm, q, JointVector::Zero()), Eigen::Vector3d::Zero());
}

TEST(Convergence, IsLeftOnlyWellBeyondTheTolerance) {
  const ConvergenceParameters parameters;
  EXPECT_TRUE(stays_converged(parameters, 0.001, 0.0019));
  EXPECT_FALSE(stays_converged(parameters, 0.001, 0.0021));
  EXPECT_TRUE(stays_converged(parameters, 0.0003, 0.001));
  EXPECT_EQ(tolerance_of(parameters, 0.0), parameters.tolerance);
  EXPECT_EQ(tolerance_of(parameters, 0.005), 0.005);
}

class HandAndTargetOfARobot : public testing::Test {
 protected:
  Sighting see(const Eigen::Vector3d& p_CM, const Eigen::Vector3d& p_CT, bool hand_located = true) {
    PoseSample pose;
    pose.utime = 7;
    pose.marks = {{"hand", hand_located, "hidden", p_CM, kCovariance}, {"red_book", true, "", p_CT, kCovariance}};
    return marks_.observe({}, *robot_.arm, pose, q_, "hand", "red_book");
  }

  robot::RobotDescription robot_ = the_robot();
  JointVector q_{0.1, 1.2, -1.0};
  Eigen::Vector3d p_CM_ = robot::hand_mark(*robot_.arm, q_);
  HandAndTarget marks_;
};

TEST_F(HandAndTargetOfARobot, TheTargetIsAveragedThoughTheHandIsHidden) {
  EXPECT_EQ(see(p_CM_, {0.0, 0.25, 0.0}, false).lost, "mark hand: hidden");
  const Sighting sighting = see(p_CM_, {0.001, 0.25, 0.0});
  EXPECT_EQ(sighting.lost, "");
  EXPECT_NEAR(sighting.p_CT.x(), 0.0005, 1e-12);
  EXPECT_EQ(sighting.p_CM, p_CM_);
  EXPECT_EQ(sighting.utime, 7);
  EXPECT_NEAR(sighting.target_covariance(0, 0), 2e-8, 1e-15);
  EXPECT_EQ(sighting.hand_covariance, kCovariance);
}

TEST_F(HandAndTargetOfARobot, AHandFarFromItsJointsIsAnotherThing) {
  EXPECT_EQ(see(p_CM_ + Eigen::Vector3d(0.05, 0.0, 0.0), {0.0, 0.25, 0.0}).lost,
            "mark hand: 0.050 m from where the joints say it is, allowed 0.040 m");
}

class PaperLawOfARobot : public testing::Test {
 protected:
  PaperLawOfARobot() {
    goal_.target = "red_book";
    goal_.p_TG_C = robot_.find_mark("red_book")->grip->p_TG;
    sighting_.q_exposure = robot::inverse_kinematics(*robot_.arm, {0.0, 0.25, -0.02}, 0.0).q;
    sighting_.p_CM = robot::hand_mark(*robot_.arm, sighting_.q_exposure);
    sighting_.p_CT = sighting_.p_CM - robot_.paper_law->offset_TM;  // where its error is zero
    JointSample there;
    there.position = sighting_.q_exposure;
    command_.adopt(there);
  }

  LawAnswer frame() { return law_.step({goal_, sighting_, joints_, command_, 1.0 / 30.0, 0.4}, state_); }

  robot::RobotDescription robot_ = the_robot();
  PaperLaw law_{robot_, {0.001, 4, 1.75, 0.0}};
  Goal goal_;
  Sighting sighting_;
  JointHistory joints_;
  ArmCommand command_;
  LawState state_;
};

TEST_F(PaperLawOfARobot, ArrivesAfterSoManyFramesInARow) {
  for (int i = 0; i < 3; ++i) {
    const LawAnswer answer = frame();
    EXPECT_EQ(answer.unreachable, "");
    EXPECT_FALSE(answer.converged);
    EXPECT_TRUE(answer.step.streaming);
  }
  const LawAnswer answer = frame();
  EXPECT_TRUE(answer.converged);
  EXPECT_TRUE(answer.settled);
  EXPECT_TRUE(answer.step.change.isZero());
  sighting_.p_CM.x() += 0.005;
  EXPECT_FALSE(frame().converged);
}

TEST_F(PaperLawOfARobot, CountsOnAfterALostMarkAndAnewAfterASilentSender) {
  for (int i = 0; i < 3; ++i) frame();
  state_.lose_sight();
  EXPECT_TRUE(frame().converged);
  state_.interrupt();
  EXPECT_FALSE(frame().converged);
}

}  // namespace
}  // namespace markservo::visual_servo::test
