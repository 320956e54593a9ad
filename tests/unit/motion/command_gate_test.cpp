// The table of command_gate.hpp, walked through.

#include "common/motion/command_gate.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <optional>

#include "common/motion/command_lead.hpp"
#include "common/motion/command_path.hpp"

namespace markservo::motion {
namespace {

constexpr std::int64_t kMover = 77;
constexpr std::int64_t kNow = 10'000'000;

// A command of `session` that answers what was measured `age` s before kNow.
OfferedCommand command(std::int64_t seq, double age = 0.0, std::int64_t session = 5) {
  return {{session, seq, kNow - static_cast<std::int64_t>(1e6 * age)}, kMover};
}

class Gate : public testing::Test {
 protected:
  Gate() { gate_.release(kNow - 1'000'000); }
  CommandVerdict hear(const OfferedCommand& one, std::int64_t now = kNow) { return gate_.hear(one, now, false); }

  CommandGate gate_{"JOINT_COMMAND", kMover};
};

TEST_F(Gate, ObeysGrowingNumbersOnce) {
  EXPECT_EQ(hear(command(3, 0.1)), CommandVerdict::kObeyed);
  EXPECT_EQ(hear(command(3, 0.1)), CommandVerdict::kOutOfOrder);
  EXPECT_EQ(hear(command(2, 0.2)), CommandVerdict::kOutOfOrder);
  EXPECT_EQ(hear(command(4, 0.0)), CommandVerdict::kObeyed);
}

TEST_F(Gate, ObeysNothingWhileLatched) {
  EXPECT_EQ(gate_.hear(command(1), kNow, true), CommandVerdict::kLatched);
}

TEST_F(Gate, ObeysOnlyWhatWasMadeForThisMover) {
  EXPECT_EQ(hear({{5, 1, kNow}, kMover + 1}), CommandVerdict::kOtherMover);
  EXPECT_EQ(hear({{5, 1, kNow}, 0}), CommandVerdict::kOtherMover);
}

TEST_F(Gate, ObeysOnlyAnswersToWhatWasMeasuredAfterTheReset) {
  gate_.release(kNow - 100'000);
  EXPECT_EQ(hear(command(1, 0.1)), CommandVerdict::kBeforeReset);
  EXPECT_EQ(hear(command(2, 0.09)), CommandVerdict::kObeyed);
}

TEST_F(Gate, ObeysNoAnswerToWhatIsOlderThanThreeTenthsOfASecondOrStillToCome) {
  EXPECT_EQ(hear(command(1, 0.300001)), CommandVerdict::kStale);
  EXPECT_EQ(hear(command(1, -0.020001)), CommandVerdict::kAhead);
  EXPECT_EQ(hear(command(1, 0.3)), CommandVerdict::kObeyed);
}

TEST_F(Gate, IsSilentThreeTenthsOfASecondAfterTheLastObeyedCommand) {
  EXPECT_TRUE(gate_.silent(kNow)) << "there was none yet";
  hear(command(1));
  EXPECT_FALSE(gate_.silent(kNow + 300'000));
  EXPECT_TRUE(gate_.silent(kNow + 300'001));
}

TEST_F(Gate, AResetForgetsTheCommandsBefore) {
  hear(command(1));
  gate_.release(kNow);
  EXPECT_TRUE(gate_.silent(kNow));
}

TEST_F(Gate, ARestartedWriterIsObeyedOnceTheFormerHasBeenSilent) {
  hear(command(100, 0.0, 5));
  EXPECT_EQ(gate_.hear({{6, 1, kNow + 200'000}, kMover}, kNow + 200'000, false), CommandVerdict::kWaits);
  EXPECT_EQ(gate_.hear({{6, 2, kNow + 310'000}, kMover}, kNow + 310'000, false), CommandVerdict::kObeyed);
}

TEST_F(Gate, TwoWritersStopTheMoverUntilOneHasBeenSilentForASecond) {
  hear(command(1, 0.1, 5));
  EXPECT_EQ(hear(command(1, 0.05, 6)), CommandVerdict::kWaits);
  EXPECT_EQ(hear(command(2, 0.0, 5)), CommandVerdict::kTwoWriters);
  EXPECT_EQ(gate_.obstacle(kNow + 900'000),
            "two write JOINT_COMMAND: sessions 5 and 6; released only when one has been silent for 1 s");
  EXPECT_EQ(gate_.obstacle(kNow + 1'100'000), "");
  gate_.release(kNow + 1'100'000);
  EXPECT_EQ(gate_.hear({{5, 3, kNow + 1'110'000}, kMover}, kNow + 1'120'000, false), CommandVerdict::kObeyed);
}

TEST_F(Gate, ObeysNothingThatLeadsTheShaftsOrJumpsAwayFromTheCommandBeforeIt) {
  OfferedCommand leads = command(1, 0.2);
  leads.leads = true;
  EXPECT_EQ(hear(leads), CommandVerdict::kLeads);
  OfferedCommand jumps = command(2, 0.1);
  jumps.jumps = true;
  EXPECT_EQ(hear(jumps), CommandVerdict::kJumps);
  EXPECT_EQ(hear(command(3, 0.0)), CommandVerdict::kObeyed);
}

TEST_F(Gate, AnOldRecordingIsNoWriter) {
  hear(command(1, 0.1, 5));
  EXPECT_EQ(hear(command(1, 2280.0, 6)), CommandVerdict::kStale);
  EXPECT_EQ(hear(command(2, 0.0, 5)), CommandVerdict::kObeyed);
}

TEST(CommandLead, AllowsThreeTenthsOfASecondAtTheCommandsSpeedAndATenthOfARadian) {
  const Eigen::Vector3d shaft(0.0, 1.0, -1.0);
  const Eigen::Vector3d speed(1.0, 2.0, 0.2);
  EXPECT_EQ(leading_joint<Eigen::Vector3d>(shaft + Eigen::Vector3d(0.39, -0.69, 0.15), speed, shaft), std::nullopt);
  EXPECT_EQ(leading_joint<Eigen::Vector3d>(shaft + Eigen::Vector3d(0.41, 0.0, 0.0), speed, shaft), 0U);
  EXPECT_EQ(leading_joint<Eigen::Vector3d>(shaft + Eigen::Vector3d(0.0, -0.71, 0.0), speed, shaft), 1U);
  EXPECT_EQ(leading_joint<Eigen::Vector3d>(shaft + Eigen::Vector3d(0.0, 0.0, 0.17), speed, shaft), 2U);
}

class Path : public testing::Test {
 protected:
  // Of a command `step` (rad) from the last one, `seconds` after it, told at `speed` (rad/s).
  std::optional<std::size_t> jump(const Eigen::Vector3d& step, double seconds, double speed) const {
    return path_.jumping_joint<Eigen::Vector3d>(last_ + step, Eigen::Vector3d::Constant(speed), shaft_,
                                                kNow + static_cast<std::int64_t>(1e6 * seconds));
  }

  CommandPath path_;
  const Eigen::Vector3d last_{0.0, 0.5, -1.0};
  const Eigen::Vector3d shaft_ = last_ - Eigen::Vector3d(0.1, 0.1, 0.1);  // on its way there
};

TEST_F(Path, GoesOnAtTheToldSpeedOrByAShortStep) {
  path_.follow(last_, kNow);
  EXPECT_EQ(jump({0.0, 0.0, 0.059}, 0.05, 1.0), std::nullopt);
  EXPECT_EQ(jump({0.0, 0.0, 0.061}, 0.05, 1.0), 2U);
  EXPECT_EQ(jump({0.0, -0.061, 0.0}, 0.05, 1.0), 1U);
  EXPECT_EQ(jump({0.0, -0.061, 0.0}, 0.1, 1.0), std::nullopt) << "twice as long since the last";
  EXPECT_EQ(jump({0.034, 0.0, 0.0}, 0.03, 0.2), std::nullopt);
  EXPECT_EQ(jump({0.036, 0.0, 0.0}, 0.03, 0.2), 0U);
}

TEST_F(Path, AWriterMayTakeTheShaftsWhereTheyAre) {
  path_.follow(last_, kNow);
  EXPECT_EQ(jump(shaft_ - last_, 0.03, 0.2), std::nullopt);
  EXPECT_EQ(jump(shaft_ - last_ + Eigen::Vector3d(0.0, 0.0, -0.04), 0.03, 0.2), 0U);
}

TEST_F(Path, BeginsAnywhereAtFirstAndAfterStanding) {
  EXPECT_EQ(jump({1.0, 0.0, 0.0}, 0.03, 0.2), std::nullopt);
  path_.follow(last_, kNow);
  EXPECT_EQ(jump({1.0, 0.0, 0.0}, 0.03, 0.2), 0U);
  path_.forget();
  EXPECT_EQ(jump({1.0, 0.0, 0.0}, 0.03, 0.2), std::nullopt);
}

TEST_F(Path, ATimeThatGoesBackGivesNoWay) {
  path_.follow(last_, kNow);
  EXPECT_EQ(jump({0.04, 0.0, 0.0}, -1.0, 1.0), 0U);
}

}  // namespace
}  // namespace markservo::motion
