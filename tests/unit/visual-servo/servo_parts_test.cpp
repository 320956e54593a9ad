// The servo's parts, each by itself.

#include <cmath>

#include "services/visual-servo/laws/paper_law.hpp"
#include "services/visual-servo/sight/in_flight.hpp"
#include "tests/unit/visual-servo/rig.hpp"

namespace markservo::visual_servo::test {
namespace {

const JointVector kServoSpeed = JointVector::Constant(5.2);

JointSample sample_at(std::int64_t utime, double yaw) {
  JointSample sample;
  sample.utime = utime;
  sample.position = {yaw, 0.0, 0.0};
  return sample;
}

TEST(JointHistory, InterpolatesAtTheExposure) {
  JointHistory history;
  history.add(sample_at(1'000'000, 0.1), kServoSpeed);
  history.add(sample_at(1'010'000, 0.2), kServoSpeed);
  EXPECT_NEAR(history.at(1'004'000)[0], 0.14, 1e-12);
  EXPECT_NEAR(history.at(990'000)[0], 0.1, 1e-12);
}

TEST(JointHistory, BeginsAnewWithALeap) {
  JointHistory history;
  EXPECT_FALSE(history.add(sample_at(1'000'000, 0.1), kServoSpeed));
  EXPECT_FALSE(history.add(sample_at(1'010'000, 0.12), kServoSpeed));
  EXPECT_TRUE(history.add(sample_at(1'020'000, 1.0), kServoSpeed));
  EXPECT_EQ(history.at(0)[0], 1.0);
}

TEST(JointHistory, PassesOverWhatIsNotNewer) {
  JointHistory history;
  history.add(sample_at(1'000'000, 0.1), kServoSpeed);
  EXPECT_FALSE(history.add(sample_at(990'000, 0.5), kServoSpeed));
  EXPECT_FALSE(history.add(sample_at(1'000'000, 0.5), kServoSpeed));
  EXPECT_EQ(history.newest().position[0], 0.1);
}

TEST(JointHistory, KnowsSinceWhenTheArmIsThere) {
  JointHistory history;
  for (int i = 0; i <= 10; ++i) history.add(sample_at(std::int64_t{10'000} * i, std::min(0.01 * i, 0.05)), kServoSpeed);
  EXPECT_EQ(history.near_since({0.05, 0.0, 0.0}, 1e-3), 50'000);
  EXPECT_FALSE(history.near_since({0.06, 0.0, 0.0}, 1e-3));
}

TEST(JointHistory, KnowsHowFastTheJointsCame) {
  JointHistory history;
  for (int i = 0; i <= 10; ++i) history.add(sample_at(std::int64_t{10'000} * i, 0.003 * i), kServoSpeed);
  EXPECT_NEAR(history.speed(85'000)[0], 0.3, 1e-9);
}

class JointHistoryOfAYaw : public testing::Test {
 protected:
  void turn_to(double yaw, double play = 0.0) {
    history_.add(sample_at(utime_, yaw), kServoSpeed, play);
    utime_ += 10'000;
  }
  double trailing() const { return history_.trailing(history_.newest().utime)[0]; }

  JointHistory history_;
  std::int64_t utime_ = 0;
};

TEST_F(JointHistoryOfAYaw, KnowsTheLastDirectionOfAJointThatRests) {
  // Up for 0.1 s, down for 0.1 s, then at rest but for its reading's last digit.
  for (int i = 0; i <= 60; ++i) {
    turn_to((i <= 10 ? 0.01 * i : std::max(0.2 - 0.01 * i, 0.0)) + (i % 2 == 0 ? 0.0 : 0.0001));
  }
  EXPECT_EQ(history_.trailing(80'000), JointVector(1.0, 0.0, 0.0));
  EXPECT_NEAR(trailing(), -1.0, 1e-9);
  for (int i = 0; i < 140; ++i) turn_to(0.0);
  EXPECT_NEAR(trailing(), -1.0, 1e-9) << "longer ago than its samples go back";
}

TEST_F(JointHistoryOfAYaw, KnowsTheDirectionOfAJointThatCreeps) {
  for (int i = 0; i <= 100; ++i) turn_to(0.0001 * i);
  EXPECT_EQ(trailing(), 1.0);
}

TEST_F(JointHistoryOfAYaw, KnowsWhereAShaftIsThatHasCrossedItsPlayInPart) {
  constexpr double kPlay = 0.005;  // rad, half of what it can cross
  turn_to(0.0, kPlay);
  EXPECT_EQ(trailing(), 0.0);
  turn_to(0.05, kPlay);
  EXPECT_EQ(trailing(), 1.0);
  turn_to(0.05 - kPlay, kPlay);
  EXPECT_NEAR(trailing(), 0.0, 1e-9);
  turn_to(0.05 - 1.5 * kPlay, kPlay);
  EXPECT_NEAR(trailing(), -0.5, 1e-9);
  turn_to(0.05 - 3.0 * kPlay, kPlay);
  EXPECT_EQ(trailing(), -1.0);
}

TEST_F(JointHistoryOfAYaw, KnowsNothingOfAJointThatMayHaveBeenMovedUnseen) {
  for (int i = 0; i <= 10; ++i) turn_to(0.01 * i);
  EXPECT_EQ(trailing(), 1.0);
  utime_ += 500'000;
  turn_to(0.1);
  EXPECT_EQ(trailing(), 0.0);
}

TEST(StillTarget, AveragesNoiseAway) {
  StillTarget target;
  for (int i = 0; i < 30; ++i) target.observe({}, {i % 2 == 0 ? 0.0002 : -0.0002, 0.25, 0.0}, kCovariance);
  EXPECT_NEAR(target.position().x(), 0.0, 1e-9);
  EXPECT_NEAR(target.covariance()(0, 0), kCovariance(0, 0) / 30.0, 1e-12);
}

TEST(StillTarget, PassesOverOneOutlierAndFollowsAMove) {
  StillTarget target;
  for (int i = 0; i < 10; ++i) target.observe({}, {0.0, 0.25, 0.0}, kCovariance);
  target.observe({}, {0.05, 0.25, 0.0}, kCovariance);
  EXPECT_EQ(target.position().x(), 0.0);
  target.observe({}, {0.05, 0.25, 0.0}, kCovariance);
  EXPECT_EQ(target.position().x(), 0.05);
}

TEST(InFlight, SeesTheGripPointWhereverTheArmStands) {
  const auto robot = the_robot();
  robot::ArmDescription moved = *robot.arm;
  moved.p_CA += Eigen::Vector3d(0.003, -0.002, 0.004);
  const JointVector q(0.3, 1.2, -0.9);
  const Eigen::Vector3d seen = seen_grip_point(*robot.arm, q, robot::hand_mark(moved, q));
  EXPECT_LT((seen - robot::grip_point(moved, q)).norm(), 1e-12);
}

TEST(InFlight, PredictsTheMotionThatIsNotYetSeen) {
  const auto robot = the_robot();
  const JointVector q_exposure(0.3, 1.2, -0.9);
  const JointVector q_command(0.35, 1.15, -0.8);
  const Eigen::Vector3d bias = kinematic_bias(*robot.arm, q_exposure, robot::hand_mark(*robot.arm, q_exposure));
  EXPECT_LT((predicted_grip_point(*robot.arm, q_command, bias) - robot::grip_point(*robot.arm, q_command)).norm(),
            1e-12);
}

TEST(SettledWindow, RemembersMoreFramesOnlyWhileInDoubt) {
  const SettlingParameters parameters;
  SettledWindow window;
  for (int i = 0; i < 4; ++i) window.add(parameters, Eigen::Vector3d(0.0002, 0.0, 0.0));
  window.add(parameters, Eigen::Vector3d::Zero());
  EXPECT_EQ(window.size(), 4);
  window.look_longer();
  for (int i = 0; i < 4; ++i) window.add(parameters, Eigen::Vector3d::Zero());
  EXPECT_EQ(window.size(), 8);
  EXPECT_NEAR(window.mean().x(), 0.000075, 1e-9);
  window.forget();
  for (int i = 0; i < 6; ++i) window.add(parameters, Eigen::Vector3d::Zero());
  EXPECT_EQ(window.size(), 4);
}

TEST(KinematicBias, LearnsWhereTheArmStandsAndHowLongItsLinksAre) {
  const auto robot = the_robot();
  robot::ArmDescription truth = *robot.arm;
  truth.p_CA += Eigen::Vector3d(0.003, -0.002, 0.004);
  truth.upper_arm *= 1.01;
  truth.forearm *= 0.99;
  KinematicBias bias;
  KinematicBiasParameters parameters;
  for (int i = 0; i < 60; ++i) {
    const JointVector q(0.5 - 0.01 * i, 1.5 - 0.01 * i, -1.8 + 0.02 * i);
    bias.observe(*robot.arm, parameters, {q, {-0.3, -0.3, 0.6}, {-1.0, -1.0, 1.0}}, robot::hand_mark(truth, q));
  }
  const JointVector ahead(-0.2, 0.85, -0.5);  // further on, never seen
  const Eigen::Vector3d expected = robot::grip_point(truth, ahead) - robot::grip_point(*robot.arm, ahead);
  EXPECT_LT((bias.at(*robot.arm, ahead, {-1.0, -1.0, 1.0}) - expected).norm(), 0.0003);
}

TEST(KinematicBias, IsNotSpoiltByShaftsThatTrailBehindAMovingArm) {
  const auto robot = the_robot();
  constexpr double kFrame_s = 1.0 / 30.0;
  constexpr double kPlay = 0.005;             // rad
  const JointVector fastest(0.9, -0.9, 1.7);  // rad/s
  JointVector q(0.3, 1.5, -1.8);
  KinematicBias bias;
  for (int frame = -5; frame <= 16; ++frame) {
    // At rest, gathering speed, braking to a tenth.
    const JointVector speed = fastest * (frame < 0 ? 0.0 : std::min(1.0, 0.2 * frame) * (frame < 12 ? 1.0 : 0.1));
    q += kFrame_s * speed;
    const JointVector directions = frame < 1 ? JointVector::Zero() : JointVector(1.0, -1.0, 1.0);
    const JointVector trailing = kPlay * directions + 0.004 * speed + 0.005 * speed.cwiseProduct(speed.cwiseAbs());
    bias.observe(*robot.arm, {}, {q, speed, directions}, robot::hand_mark(*robot.arm, q - trailing));
  }
  const JointVector arrived(1.0, -1.0, 1.0);
  const Eigen::Vector3d expected =
      robot::grip_point(*robot.arm, q - kPlay * arrived) - robot::grip_point(*robot.arm, q);
  EXPECT_LT((bias.at(*robot.arm, q, arrived) - expected).norm(), 0.0003);
}

TEST(KinematicBias, KnowsByWhichAngleTheShaftsTrailOnceAJointHasTurned) {
  const auto robot = the_robot();
  constexpr double kPlay = 0.005;  // rad
  KinematicBias bias;
  const auto rest_at = [&](const JointVector& q, const JointVector& trailing) {
    for (int i = 0; i < 6; ++i) {
      bias.observe(*robot.arm, {}, {q, JointVector::Zero(), trailing},
                   robot::hand_mark(*robot.arm, q - kPlay * trailing));
    }
  };
  const JointVector q(0.3, 1.2, -1.2);
  rest_at(q, {-1.0, -1.0, 1.0});
  const JointVector turned(1.0, -1.0, 1.0);
  rest_at(q, turned);
  EXPECT_LT((bias.shafts(q, turned) - (q - kPlay * turned)).cwiseAbs().maxCoeff(), 0.001);
  EXPECT_EQ(bias.shafts(q, JointVector::Zero()), q) << "nothing is known of where in their play they are";
}

TEST(ResolvedRate, LimitsShortenTheStepAndKeepItsDirection) {
  const auto robot = the_robot();
  const JointVector q(0.2, 1.3, -1.2);
  const Eigen::Vector3d to_go(0.03, 0.08, 0.02);
  const ResolvedRateParameters parameters;
  const JointVector step = resolved_rate_step(*robot.arm, parameters, q, to_go, 1.0 / 30.0, 0.1, 0.1);
  const Eigen::Vector3d moved = robot::grip_point_jacobian(*robot.arm, q) * step;
  EXPECT_LE(moved.norm(), 0.1 / 30.0 + 1e-9);
  EXPECT_GT(moved.normalized().dot(to_go.normalized()), 0.999);
}

TEST(ResolvedRate, NeverLeavesTheJointLimits) {
  const auto robot = the_robot();
  const JointVector at_limit(robot.arm->joints[0].max, 1.3, -1.2);
  const JointVector step =
      resolved_rate_step(*robot.arm, ResolvedRateParameters(), at_limit, {-0.1, -0.1, 0.0}, 1.0 / 30.0, 0.4, 0.4);
  EXPECT_LE(at_limit[0] + step[0], robot.arm->joints[0].max);
}

TEST(OneSided, BackingOffDrawsTheHandBackAndNeverInOrSideways) {
  const auto robot = the_robot();
  for (const double y : {0.20, 0.25, 0.30}) {
    const JointVector goal = robot::inverse_kinematics(*robot.arm, {0.0325, y, -0.02}, 0.0).q;
    const JointVector directions = ending_directions(goal + JointVector(0.2, 0.0, 0.0), goal);
    const JointVector entry = entry_posture(*robot.arm, OneSidedParameters(), goal, directions);
    const Eigen::Vector3d moved = robot::grip_point(*robot.arm, entry) - robot::grip_point(*robot.arm, goal);
    EXPECT_LT(moved.y(), -0.004);
    EXPECT_LT(std::abs(moved.z()), 0.003);
    EXPECT_EQ(directions, JointVector(-1.0, -1.0, 1.0));
  }
}

TEST(OneSided, EveryCorrectionEndsInItsDirectionByASureMove) {
  const auto robot = the_robot();
  const OneSidedParameters parameters;
  const JointVector q(0.1, 1.2, -1.0);
  const JointVector directions(1.0, -1.0, 1.0);
  const Correction correction = plan_correction(*robot.arm, parameters, q, {-0.004, -0.002, 0.0001}, directions);
  EXPECT_TRUE(correction.backs_off);
  EXPECT_EQ(correction.final[2], q[2]);  // too little to touch
  const JointVector before = last_but_one(parameters, correction.via, correction.final, directions);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR((correction.final[i] - before[i]) * directions[i], parameters.last_move, 1e-12);
    EXPECT_GT((before[i] - correction.via[i]) * directions[i], 0.0);
  }
}

TEST(PaperLaw, EachJointFollowsOneAxis) {
  robot::PaperLawDescription law;
  law.gains = {31.2, 44.7, -92.4};
  law.offset_TM = {0.0, -0.04, -0.04};
  const Eigen::Vector3d p_CT(0.0, 0.25, 0.03);
  const Eigen::Vector3d error = paper_error(law, {0.01, 0.20, 0.0}, p_CT, Eigen::Vector3d::Zero());
  EXPECT_LT((error - Eigen::Vector3d(0.01, -0.01, 0.01)).norm(), 1e-12);
  const JointVector step = paper_step(law, error, 0.1, 10.0);
  EXPECT_LT((step - JointVector(0.0312, -0.0447, -0.0924)).norm(), 1e-12);
  EXPECT_NEAR(paper_step(law, error, 0.1, 0.1)[2], -0.01, 1e-12);  // the joints' speed limit
}

TEST(PaperLaw, NeedsItsGains) {
  auto robot = the_robot();
  robot.paper_law.reset();
  Parameters parameters;
  parameters.law = Law::kPaper;
  EXPECT_THROW(ServoStateMachine(robot, parameters), std::invalid_argument);
}

}  // namespace
}  // namespace markservo::visual_servo::test
