// What of a log may go to a bus that a robot may be on, and when.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <markservo/StopRequest.hpp>
#include <markservo/channels.hpp>

#include "services/log-tool/play_choice.hpp"
#include "services/log-tool/play_schedule.hpp"
#include "tests/unit/logs/log_bytes.hpp"

namespace markservo::log_tool {
namespace {

PlayWishes named(const std::string& expression) {
  PlayWishes wishes;
  wishes.channels = ChannelPattern(expression);
  return wishes;
}

PlayWishes all() {
  PlayWishes wishes;
  wishes.all = true;
  return wishes;
}

PlayWishes all_of(const std::string& expression) {
  PlayWishes wishes = named(expression);
  wishes.all = true;
  return wishes;
}

PlayWishes join(const std::set<std::string>& written = {}) {
  PlayWishes wishes;
  wishes.join = true;
  wishes.written = written;
  return wishes;
}

TEST(PlayedChannels, AreThoseOfTheTableThatDoNotMove) {
  for (const channels::Entry& entry : channels::kAll) {
    const Fate fate = fate_of(entry.name, {});
    EXPECT_EQ(fate == Fate::kMoves, entry.moves_robot) << entry.name;
    EXPECT_EQ(fate == Fate::kLive, entry.live) << entry.name;
    EXPECT_EQ(fate == Fate::kPlayed, !entry.moves_robot && !entry.live) << entry.name;
  }
}

TEST(PlayedChannels, AreNotMovingOnesOfAnyRobot) {
  EXPECT_EQ(fate_of("r1/STOP", {}), Fate::kMoves);
  EXPECT_EQ(fate_of("a/b/SERVO_GOAL", {}), Fate::kMoves);
  EXPECT_EQ(fate_of("r1/TARGET_POSE", {}), Fate::kPlayed);
}

TEST(PlayedChannels, AreUnlistedOnesOnlyWhenNamed) {
  EXPECT_EQ(fate_of("MOTOR_COMMAND", {}), Fate::kUnlisted);
  EXPECT_EQ(fate_of("MOTOR_COMMAND", named("MOTOR_\\w+")), Fate::kPlayed);
  EXPECT_EQ(fate_of("TARGET_POSE", named("MOTOR_\\w+")), Fate::kNotNamed);
  EXPECT_EQ(fate_of("MOTOR_COMMAND", all()), Fate::kUnlisted) << "nobody knows what it moves";
  for (const char* no_name : {".*", "\\w+", "\\S+", "[A-Z_]+"}) {
    EXPECT_EQ(fate_of("MOTOR_COMMAND", named(no_name)), Fate::kUnlisted) << no_name;
  }
  EXPECT_EQ(fate_of("MOTOR_COMMAND", all_of(".*")), Fate::kPlayed) << "all of everything";
  EXPECT_EQ(fate_of(kLcmSelfTest, {}), Fate::kNotNamed) << "in every recording: not worth a word";
}

TEST(PlayedChannels, AreNeverMovingOnesForAnExpressionThatTakesThem) {
  EXPECT_EQ(fate_of("STOP", named(".*")), Fate::kMoves);
  EXPECT_EQ(fate_of("STOP", named("STOP")), Fate::kMoves);
  EXPECT_EQ(fate_of("STOP", all()), Fate::kPlayed);
}

TEST(PlayedChannels, HaveNamesThatNeverAreExpressions) {
  for (const char* name : {"P\\E|.*|\\Q", ".*", "STOP|TASK_COMMAND", "(", "$(STOP)"}) {
    EXPECT_EQ(fate_of(name, {}), Fate::kUnlisted) << name;
  }
  EXPECT_EQ(fate_of("TARGET_POSE", named("TARGET.POSE")), Fate::kPlayed);
}

TEST(PlayedChannels, HaveNamesThatABusCarries) {
  EXPECT_EQ(fate_of(std::string("STOP\0X", 6), all_of(".*")), Fate::kNoName) << "the bus would carry STOP";
  EXPECT_EQ(fate_of("", all_of(".*")), Fate::kNoName);
  EXPECT_EQ(fate_of(std::string(64, 'A'), all_of(".*")), Fate::kNoName);
  EXPECT_EQ(fate_of(std::string(63, 'A'), all_of(".*")), Fate::kPlayed);
}

TEST(PlayedBesideOthers, IsNothingThatMotionDependsOnAndNothingWritten) {
  for (const channels::Entry& entry : channels::kAll) {
    EXPECT_EQ(fate_of(entry.name, join()) == Fate::kPlayed, !entry.feeds_motion && !entry.live) << entry.name;
  }
  EXPECT_EQ(fate_of("JOINT_STATE", join()), Fate::kFeedsMotion);
  EXPECT_EQ(fate_of("JOINT_STATE", join({"JOINT_STATE"})), Fate::kWritten);
  EXPECT_EQ(fate_of("r2/STEREO_MATCHES", join({"STEREO_MATCHES"})), Fate::kPlayed);
  EXPECT_EQ(fate_of("STEREO_MATCHES", join({"STEREO_MATCHES"})), Fate::kWritten);
}

TEST(PlayedBesideOthers, IsNothingThatMovesEvenWithAll) {
  PlayWishes wishes = join();
  wishes.all = true;
  EXPECT_EQ(fate_of("STOP", wishes), Fate::kFeedsMotion);
}

StopRequest release() {
  StopRequest request{};
  request.kind = StopRequest::RESET;
  return request;
}

std::vector<logs::OwnedEvent> disguised() {
  return {{0, 1, "TARGET_POSE", logs::payload(logs::target_pose(1, 7, 1))},
          {1, 2, "TARGET_POSE", logs::payload(release())},
          {2, 3, "MINE", logs::payload(release())},
          {3, 4, "STOP", logs::payload(release())}};
}

TEST(PlayPlan, HasNoMessageOfAMovingTypeWhateverItsChannelIsCalled) {
  const auto events = disguised();
  const PlayPlan plan = plan_of(logs::views(events), named("MINE|STOP|TARGET_POSE"), reflection::TypeCatalog::ours());
  ASSERT_EQ(plan.events.size(), 1U);
  EXPECT_EQ(plan.events[0].number, 0);
  EXPECT_EQ(plan.moving_messages, (std::map<std::string, std::int64_t>{{"MINE", 1}, {"TARGET_POSE", 1}}));
  EXPECT_EQ(plan.played, (std::set<std::string>{"TARGET_POSE"}));
}

TEST(PlayPlan, HasAllWhenAllIsAskedFor) {
  const auto events = disguised();
  EXPECT_EQ(plan_of(logs::views(events), all_of(".*"), reflection::TypeCatalog::ours()).events.size(), 4U);
}

// What another system would say, and on a channel that we have too.
std::vector<logs::OwnedEvent> others() {
  return {{0, 1, "MOTOR_COMMAND", std::string(20, 'x')},
          {1, 2, "TARGET_POSE", std::string(20, 'x')},
          {2, 3, "TARGET_POSE", "short"},
          {3, 4, "TARGET_POSE", logs::payload(logs::target_pose(1, 7, 1))}};
}

TEST(PlayPlan, HasNoMessageOfAnotherSystemThatIsNotNamed) {
  const auto events = others();
  for (const PlayWishes& wishes : {PlayWishes(), all(), named(".*")}) {
    const PlayPlan plan = plan_of(logs::views(events), wishes, reflection::TypeCatalog::ours());
    ASSERT_EQ(plan.events.size(), 1U);
    EXPECT_EQ(plan.events[0].number, 3);
    EXPECT_EQ(plan.others_messages, (std::map<std::string, std::int64_t>{{"TARGET_POSE", 2}}));
    const auto lines = left_out_text(plan);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0],
              "left out: MOTOR_COMMAND (not in the table of channels: another system's, which may move a robot; "
              "--channel NAME plays it)");
    EXPECT_EQ(lines[1], "left out: 2 messages on TARGET_POSE of a type that is not ours (--channel NAME plays them)");
  }
  EXPECT_EQ(plan_of(logs::views(events), named("TARGET_POSE|MOTOR.*"), reflection::TypeCatalog::ours()).events.size(),
            4U);
}

TEST(PlayPlan, SaysWhichOfAnotherSystemsChannelsItPlays) {
  const auto events = others();
  const auto& types = reflection::TypeCatalog::ours();
  EXPECT_EQ(others_played_text(plan_of(logs::views(events), named("TARGET_POSE|MOTOR.*"), types)),
            "also plays MOTOR_COMMAND (not in the table of channels: another system's, which may move a robot)");
  EXPECT_EQ(others_played_text(plan_of(logs::views(events), named("TARGET_POSE"), types)), "");
}

TEST(PlayPlan, HasNoMessageThatTheBusWouldLose) {
  const std::vector<logs::OwnedEvent> events = {{0, 1, "MAP", std::string(8'000'000, 'x')},
                                                {1, 2, "MAP", std::string(8'300'000, 'x')}};
  PlayWishes wishes = named("MAP");
  const PlayPlan plan = plan_of(logs::views(events), wishes, reflection::TypeCatalog::ours());
  ASSERT_EQ(plan.events.size(), 1U);
  EXPECT_EQ(plan.events[0].number, 0);
  EXPECT_EQ(
      left_out_text(plan),
      (std::vector<std::string>{"left out: 1 message on MAP of up to 8.3 MB: above 8 MB a bus by UDP loses them"}));
  wishes.by_udp = false;
  EXPECT_EQ(plan_of(logs::views(events), wishes, reflection::TypeCatalog::ours()).events.size(), 2U);
}

TEST(PlayPlan, IsGivenUpAsSoonAsItIsTold) {
  const auto events = disguised();
  int asked = 0;
  const PlayPlan plan =
      plan_of(logs::views(events), all_of(".*"), reflection::TypeCatalog::ours(), [&asked] { return ++asked < 3; });
  EXPECT_EQ(plan.events.size(), 2U);
}

TEST(PlayPlan, SaysWhatIsLeftOutAndWhatPlaysIt) {
  auto events = disguised();
  events.push_back({4, 5, "A\x1b]0;", "?"});
  const auto lines = left_out_text(plan_of(logs::views(events), {}, reflection::TypeCatalog::ours()));
  EXPECT_EQ(lines, (std::vector<std::string>{
                       "left out: STOP (moves a robot; --all plays it)",
                       "left out: MINE, A?]0; (not in the table of channels: another system's, which may move a robot; "
                       "--channel NAME plays it)",
                       "left out: 1 message on TARGET_POSE of a type that moves a robot (--all plays them)"}));
}

TEST(PlaySchedule, KeepsTheRecordedPaceWhateverIsLate) {
  PlaySchedule schedule(2.0);
  EXPECT_EQ(schedule.due_us(1'000'000, 500), 500);
  EXPECT_EQ(schedule.due_us(3'000'000, 600), 1'000'500);
  EXPECT_EQ(schedule.due_us(4'000'000, 1'700'000), 1'500'500) << "due before it could be sent: no delay adds up";
}

TEST(PlaySchedule, TakesALittleDisorderForNoJump) {
  PlaySchedule schedule(1.0);
  schedule.due_us(1'000'000, 0);
  schedule.due_us(2'000'000, 1'000'000);
  EXPECT_EQ(schedule.due_us(1'900'000, 1'000'000), 900'000);
  EXPECT_EQ(schedule.due_us(2'500'000, 1'000'000), 1'500'000);
}

TEST(PlaySchedule, BeginsAnewWhereTheLogsTimeJumps) {
  constexpr std::int64_t kDay_us = 86'400'000'000;
  PlaySchedule schedule(1.0);
  schedule.due_us(10'000'000, 0);
  EXPECT_EQ(schedule.due_us(1'000'000, 50), 50) << "back";
  EXPECT_EQ(schedule.due_us(2'000'000, 60), 1'000'050);
  EXPECT_EQ(schedule.due_us(3 * kDay_us, 70), 70) << "on by days";
  EXPECT_EQ(schedule.due_us(std::numeric_limits<std::int64_t>::min(), 80), 80);
  EXPECT_EQ(schedule.due_us(std::numeric_limits<std::int64_t>::max(), 90), 90);
}

// s from the first event's sending to the last's, where sending takes no time.
double played_s(const std::vector<std::int64_t>& utimes, double longest_gap = std::numeric_limits<double>::infinity()) {
  PlaySchedule schedule(1.0, longest_gap);
  std::int64_t now_us = 0;
  for (const std::int64_t utime : utimes) now_us = std::max(now_us, schedule.due_us(utime, now_us));
  return 1e-6 * static_cast<double>(now_us);
}

double announced_s(const std::vector<std::int64_t>& utimes) {
  TimeWalk walk;
  for (const std::int64_t utime : utimes) walk.to(utime);
  return walk.waited_s();
}

// Sources in turn, 0.1 s from round to round, each on a clock of its own.
std::vector<std::int64_t> mixed_clocks(const std::vector<std::int64_t>& ahead_s) {
  std::vector<std::int64_t> utimes;
  for (std::int64_t round = 0; round < 12; ++round) {
    for (const std::int64_t ahead : ahead_s) utimes.push_back(100'000 * round + 1'000'000 * ahead);
  }
  return utimes;
}

TEST(PlaySchedule, DoesNotWaitForEachStepToTheOtherOfTwoClocks) {
  EXPECT_NEAR(played_s(mixed_clocks({0, 5})), 6.1, 1e-6) << "the first is a gap, for all that is known";
  EXPECT_NEAR(played_s(mixed_clocks({5, 0})), 1.1, 1e-6);
  EXPECT_LT(played_s(mixed_clocks({0, 5, 10})), 10.0 + 5.0 + 1.2);
  EXPECT_NEAR(announced_s(mixed_clocks({0, 5})), 6.1, 1e-6) << "which is announced";
}

TEST(PlaySchedule, WaitsForPartsInTheWrongOrderAsLongAsTheyTook) {
  std::vector<std::int64_t> utimes;
  for (const std::int64_t part : {1, 0, 2}) {
    for (std::int64_t i = 0; i < 50; ++i) utimes.push_back(100'000'000 * part + 2'000'000 * i);
  }
  EXPECT_NEAR(played_s(utimes), 3 * 98.0 + 2.0, 2.1);
}

TEST(PlaySchedule, ShortensNoDisorder) {
  std::vector<std::int64_t> utimes;
  for (std::int64_t i = 0; i <= 20; ++i) utimes.push_back(100'000 * i + (i % 2 == 0 ? 0 : -900'000));
  EXPECT_NEAR(played_s(utimes, 0.5), 2.0, 1e-6);
}

TEST(PlaySchedule, ShortensGapsWhereAskedTo) {
  PlaySchedule schedule(2.0, 10.0);
  schedule.due_us(0, 0);
  EXPECT_EQ(schedule.due_us(8'000'000, 0), 4'000'000);
  EXPECT_EQ(schedule.due_us(308'000'000, 0), 9'000'000) << "10 s of 300 s, at twice the pace";
  EXPECT_EQ(schedule.due_us(310'000'000, 0), 10'000'000);
  EXPECT_EQ(schedule.due_us(1'000'000, 77), 77) << "a new time line";
  EXPECT_EQ(schedule.due_us(3'000'000, 0), 1'000'077);
}

}  // namespace
}  // namespace markservo::log_tool
