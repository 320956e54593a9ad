#include "services/log-tool/log_comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "services/log-tool/comparison_report.hpp"
#include "services/log-tool/log_splice.hpp"
#include "tests/unit/logs/log_bytes.hpp"

namespace markservo::log_tool {
namespace {

logs::OwnedEvent pose(std::int64_t utime, double x, std::int64_t session = 1) {
  return {0, utime + 5, "TARGET_POSE", logs::payload(logs::target_pose(utime, session, utime, x))};
}

LogComparison compared(const std::vector<logs::OwnedEvent>& recorded, const std::vector<logs::OwnedEvent>& replayed) {
  return compare(logs::views(recorded), logs::views(replayed), reflection::TypeCatalog::ours(), {});
}

TEST(LogComparison, TakesTheSameValuesByAnotherWriterAsEqual) {
  const LogComparison result = compared({pose(1, 0.5), pose(2, NAN)}, {pose(1, 0.5, 99), pose(2, NAN, 99)});
  EXPECT_TRUE(result.as_recorded());
  EXPECT_EQ(result.channels.at("TARGET_POSE").equal, 2);
  EXPECT_FALSE(result.first);
}

TEST(LogComparison, NamesTheFirstDifferenceWithBothValues) {
  const LogComparison result =
      compared({pose(1, 0.5), pose(2, 0.5), pose(3, 0.5)}, {pose(1, 0.5 + 1e-8), pose(2, 0.25), pose(3, NAN)});
  EXPECT_FALSE(result.as_recorded());
  const ChannelComparison& channel = result.channels.at("TARGET_POSE");
  EXPECT_EQ(channel.within, 1);
  EXPECT_EQ(channel.different, 2);
  ASSERT_TRUE(result.first);
  EXPECT_EQ(result.first->utime, 2);
  EXPECT_EQ(result.first->field, "marks[0].p_C.x");
  EXPECT_EQ(result.first->recorded, "0.5");
  EXPECT_EQ(result.first->replayed, "0.25");
  EXPECT_NE(comparison_text(result, {})
                .find("first difference: TARGET_POSE utime 2 marks[0].p_C.x: recorded 0.5, replayed 0.25"),
            std::string::npos);
}

TEST(LogComparison, TellsAMissingMessageFromOneWhoseInputsTheLogLacks) {
  const LogComparison result =
      compared({pose(1, 0.5), pose(2, 0.5), pose(3, 0.5), pose(4, 0.5)}, {pose(2, 0.5), pose(4, 0.5)});
  const ChannelComparison& channel = result.channels.at("TARGET_POSE");
  EXPECT_EQ(channel.outside, 1);
  EXPECT_EQ(channel.missing, 1);
  EXPECT_FALSE(result.as_recorded());
  EXPECT_EQ(result.first->utime, 3);
}

TEST(LogComparison, SeesAReplayThatEndsEarlyBeginsLateOrAnswersElsewhere) {
  const std::vector<logs::OwnedEvent> recorded = {pose(1, 0.5), pose(2'000'000, 0.5), pose(4'000'000, 0.5)};
  EXPECT_EQ(compared(recorded, {pose(1, 0.5), pose(2'000'000, 0.5)}).channels.at("TARGET_POSE").missing, 1);
  EXPECT_EQ(compared(recorded, {pose(4'000'000, 0.5)}).channels.at("TARGET_POSE").missing, 1);
  logs::OwnedEvent elsewhere = pose(1, 0.5);
  elsewhere.channel = "TARGET_POSES";
  EXPECT_FALSE(compared(recorded, {elsewhere}).as_recorded());
  EXPECT_FALSE(compared(recorded, {}).as_recorded());
}

TEST(LogComparison, CountsWhatTheLiveServiceSkippedAsNoDifference) {
  const LogComparison result = compared({pose(1, 0.5), pose(3, 0.5)}, {pose(1, 0.5), pose(2, 0.5), pose(3, 0.5)});
  EXPECT_EQ(result.channels.at("TARGET_POSE").extra, 1);
  EXPECT_TRUE(result.as_recorded());
  EXPECT_FALSE(result.complete());
}

TEST(LogComparison, SeesAnElementMoreAndAnotherType) {
  TargetPose longer = logs::target_pose(1, 1, 1, 0.5);
  longer.num_marks = 2;
  longer.marks.resize(2);
  const LogComparison more = compared({pose(1, 0.5)}, {{0, 6, "TARGET_POSE", logs::payload(longer)}});
  EXPECT_FALSE(more.as_recorded());
  EXPECT_EQ(more.first->field, "num_marks");
  StopState other{};
  other.utime = 1;
  EXPECT_FALSE(compared({pose(1, 0.5)}, {{0, 6, "TARGET_POSE", logs::payload(other)}}).as_recorded());
}

TEST(ExactComparison, WantsTheSameChannelsAndPayloadsInTheSameOrderAtAnyTime) {
  const std::vector<logs::OwnedEvent> one = {pose(1, 0.5), pose(2, 0.5)};
  std::vector<logs::OwnedEvent> other = one;
  other[0].utime += 1000;
  EXPECT_EQ(first_mismatch(logs::views(one), logs::views(other)), "");
  other[1].channel = "X";
  EXPECT_EQ(first_mismatch(logs::views(one), logs::views(other)), "event 1: channel TARGET_POSE here, X there");
  other = {pose(1, 0.5), pose(2, 0.6)};
  EXPECT_EQ(first_mismatch(logs::views(one), logs::views(other)), "event 1: TARGET_POSE differs in its payload");
  other.pop_back();
  EXPECT_EQ(first_mismatch(logs::views(one), logs::views(other)), "2 events here, 1 there");
}

TEST(Splice, PutsDerivedMessagesWhereTheRecordedOnesStood) {
  const auto input = [](std::int64_t utime) {
    StopState state{};
    state.utime = utime;
    return logs::OwnedEvent{0, 100 + utime, "STOP_STATE", logs::payload(state)};
  };
  const std::vector<logs::OwnedEvent> recorded = {input(1), pose(1, 0.1), input(2), pose(2, 0.1), input(3), input(4)};
  const std::vector<logs::OwnedEvent> derived = {pose(1, 0.7), pose(2, 0.7), pose(3, 0.7)};
  const std::vector<logs::OwnedEvent> wanted = {input(1), pose(1, 0.7), input(2), pose(2, 0.7),
                                                input(3), pose(3, 0.7), input(4)};
  const std::vector<logs::LogEvent> got = spliced(logs::views(recorded), logs::views(derived));
  EXPECT_EQ(first_mismatch(got, logs::views(wanted)), "");
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_EQ(got[i].number, static_cast<std::int64_t>(i));
}

}  // namespace
}  // namespace markservo::log_tool
