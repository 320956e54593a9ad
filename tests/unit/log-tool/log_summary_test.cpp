#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "services/log-tool/channel_statistics.hpp"
#include "services/log-tool/csv_table.hpp"
#include "services/log-tool/event_choice.hpp"
#include "tests/unit/logs/log_bytes.hpp"

namespace markservo::log_tool {
namespace {

const reflection::TypeCatalog& catalog() {
  return reflection::TypeCatalog::ours();
}

logs::OwnedEvent pose_event(std::int64_t utime, std::int64_t session, std::int64_t seq) {
  return {seq, utime, "TARGET_POSE", logs::payload(logs::target_pose(utime, session, seq))};
}

TEST(LogSummary, CountsLossesInEachSession) {
  const std::vector<logs::OwnedEvent> events = {pose_event(1000, 5, 1), pose_event(2000, 5, 4),
                                                pose_event(3000, 9, 7), pose_event(4000, 5, 5),
                                                pose_event(5000, 9, 9), pose_event(6000, 9, 10)};
  const LogSummary summary = summarise(logs::views(events), catalog());
  ASSERT_EQ(summary.channels.size(), 1U);
  EXPECT_EQ(summary.channels[0].type, "TargetPose");
  EXPECT_EQ(summary.channels[0].lost, 2 + 1);
  EXPECT_EQ(summary.channels[0].sessions, 2);
  EXPECT_DOUBLE_EQ(summary.channels[0].hz(), 1000.0);
}

TEST(LogSummary, ToldAnyNumbersStaysFinite) {
  constexpr auto kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max();
  const std::vector<logs::OwnedEvent> events = {pose_event(kLeast, 1, kLeast), pose_event(kMost, 1, kMost),
                                                pose_event(kLeast, kMost, 0)};
  const LogSummary summary = summarise(logs::views(events), catalog());
  EXPECT_EQ(summary.channels[0].lost, 0);
  EXPECT_EQ(summary.steps.late, 1);
  EXPECT_GT(summary.seconds(), 1e13);
}

TEST(LogSummary, NamesGapsTimesThatGoBackAndWhatCannotBeDecoded) {
  std::vector<logs::OwnedEvent> events = {pose_event(1'000'000, 5, 1), pose_event(1'500'000, 5, 2),
                                          pose_event(1'400'000, 5, 3)};
  events.push_back({4, 1'600'000, "TARGET_POSE", events[0].data.substr(0, 60)});
  events.push_back({5, 1'600'000, "TARGET_POSE", "short"});
  events.push_back({6, 1'600'000, "THEIRS", std::string(16, 'x')});
  const LogSummary summary = summarise(logs::views(events), catalog());
  EXPECT_EQ(summary.steps.late, 1);
  const ChannelSummary& poses = summary.channels[0];
  EXPECT_DOUBLE_EQ(poses.longest_gap, 0.5);
  EXPECT_EQ(poses.time_reversals, 1);
  EXPECT_EQ(poses.undecodable, 2);
  const ChannelSummary& theirs = summary.channels[1];
  EXPECT_EQ(theirs.type, "");
  EXPECT_EQ(theirs.fingerprint, 0x7878787878787878U);
  EXPECT_FALSE(theirs.lost);
  EXPECT_EQ(theirs.undecodable, 0) << "another stack's types are no damage";
}

TEST(LogSummary, CountsWhatABusWouldLose) {
  const std::vector<logs::OwnedEvent> events = {{0, 0, "BIG", std::string(8'000'001, 'x')},
                                                {1, 1, "BIG", std::string(9, 'x')}};
  const LogSummary summary = summarise(logs::views(events), catalog());
  EXPECT_EQ(summary.channels[0].too_large, 1);
  EXPECT_EQ(summary.channels[0].largest, 8'000'001);
}

TEST(EventChoice, TakesATimeSpanAndChannelsByTheirWholeName) {
  const std::vector<logs::OwnedEvent> events = {
      {0, 1'000'000, "A", "0"}, {1, 1'500'000, "AB", "1"}, {2, 2'000'000, "r/A", "2"}, {3, 2'500'000, "A", "3"}};
  const auto numbers = [&events](const EventChoice& choice) {
    std::string text;
    for (const logs::LogEvent& event : chosen(logs::views(events), choice)) text += std::to_string(event.number);
    return text;
  };
  EXPECT_EQ(numbers({}), "0123");
  EXPECT_EQ(numbers({0.5, 1.5, {}, {}}), "12");
  EXPECT_EQ(numbers({{}, {}, {"A"}, {}}), "03");
  EXPECT_EQ(numbers({{}, {}, {"A.*", "r/.*"}, {"AB"}}), "023");
  EXPECT_EQ(numbers({{}, {}, {"\\w"}, {}}), "03") << "as in every tool";
  EXPECT_THROW(numbers({{}, {}, {"("}, {}}), std::invalid_argument);
}

TEST(CsvColumns, GiveEveryFieldAColumnAndQuoteWhatNeedsIt) {
  CsvColumns columns;
  const std::vector<reflection::Leaf> one = {{"n", {std::int64_t{1}}}, {"x[0]", {0.5}}};
  const std::vector<reflection::Leaf> other = {{"n", {std::int64_t{2}}}, {"text", {std::string("a,\"b\"")}}};
  columns.learn(one);
  columns.learn(other);
  EXPECT_EQ(columns.header(), "log_utime,n,x[0],text\n");
  EXPECT_EQ(columns.row(7, one), "7,1,0.5,\n");
  EXPECT_EQ(columns.row(8, other), "8,2,,\"a,\"\"b\"\"\"\n");
}

TEST(CsvColumns, WriteANumberThatHasANameByItsName) {
  reflection::Field field;
  field.value_names = {{0, "HOLD"}, {1, "SERVO"}};
  CsvColumns columns;
  columns.learn({{"state", {std::int64_t{0}}, &field}});
  EXPECT_EQ(columns.row(7, {{"state", {std::int64_t{1}}, &field}}), "7,SERVO\n");
  EXPECT_EQ(columns.row(7, {{"state", {std::int64_t{2}}, &field}}), "7,2\n");
  EXPECT_EQ(columns.row(7, {{"state", {std::int64_t{-1}}, &field}}), "7,-1\n");
}

}  // namespace
}  // namespace markservo::log_tool
