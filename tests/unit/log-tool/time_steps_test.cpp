// How a log's time goes, and putting logs in order.

#include "services/log-tool/time_steps.hpp"

#include <gtest/gtest.h>

#include "services/log-tool/log_merge.hpp"
#include "tests/unit/logs/log_bytes.hpp"

namespace markservo::log_tool {
namespace {

constexpr std::int64_t kSecond = 1'000'000;

// Messages on `channel` at these times, us.
std::vector<logs::OwnedEvent> at(const std::vector<std::int64_t>& utimes, const std::string& channel = "A") {
  std::vector<logs::OwnedEvent> events;
  for (const std::int64_t utime : utimes) {
    events.push_back({static_cast<std::int64_t>(events.size()), utime, channel, channel + std::to_string(utime)});
  }
  return events;
}

TimeSteps steps_of(const std::vector<std::int64_t>& utimes) {
  const auto events = at(utimes);
  return time_steps(logs::views(events));
}

std::vector<std::int64_t> utimes_of(const std::vector<logs::LogEvent>& events) {
  std::vector<std::int64_t> utimes;
  for (const logs::LogEvent& event : events) utimes.push_back(event.utime);
  return utimes;
}

TEST(TimeSteps, OfALogInOrderAreNothingToTell) {
  const TimeSteps steps = steps_of({0, kSecond, kSecond, 9 * kSecond});
  EXPECT_EQ(steps.back, 0);
  EXPECT_EQ(steps.late, 0);
  EXPECT_EQ(steps.jumps, 0);
  EXPECT_EQ(disorder_text(steps), "");
  EXPECT_EQ(silences_text(steps), "");
  EXPECT_EQ(time_steps({}).back, 0);
}

TEST(TimeSteps, CountOneStepBackAndAllThatIsLateForIt) {
  const TimeSteps steps = steps_of({20 * kSecond, 21 * kSecond, 0, kSecond, 2 * kSecond});
  EXPECT_EQ(steps.back, 1);
  EXPECT_DOUBLE_EQ(steps.farthest_back, 21.0);
  EXPECT_EQ(steps.late, 3);
  EXPECT_EQ(steps.jumps, 1);
  EXPECT_EQ(disorder_text(steps), "1 time back, by 21.0 s: 3 events are out of order");
}

TEST(TimeSteps, TakeALittleDisorderForNoJump) {
  const TimeSteps steps = steps_of({kSecond, 800'000, 1'100'000, 1'050'000, 1'200'000});
  EXPECT_EQ(steps.jumps, 0);
  EXPECT_EQ(disorder_text(steps), "2 times back, by up to 0.2 s: 2 events are out of order");
}

TEST(TimeSteps, GoFarBackBySmallStepsToo) {
  std::vector<std::int64_t> backwards;
  for (std::int64_t i = 40; i > 0; --i) backwards.push_back(50'000 * i);
  EXPECT_EQ(disorder_text(steps_of(backwards)), "39 times back, by up to 1.9 s: 39 events are out of order");
}

TEST(TimeSteps, AreToldInTheUnitThatFits) {
  EXPECT_EQ(duration_text(0.0), "0.0 s");
  EXPECT_EQ(duration_text(0.0035), "3.5 ms");
  EXPECT_EQ(duration_text(3.9), "3.9 s");
  EXPECT_EQ(duration_text(210.0), "3.5 min");
  EXPECT_EQ(duration_text(7560.0), "2.1 h");
  EXPECT_EQ(duration_text(40.0 * 86400.0), "40 days");
}

TEST(TimeSteps, TellSilencesTheLongestFirstAndNoJumpOfDays) {
  std::vector<std::int64_t> utimes = {0, 15 * kSecond, 300 * kSecond};
  EXPECT_EQ(silences_text(steps_of(utimes)), "nothing for 4.8 min after 15.0 s, for 15.0 s after 0.0 s");
  utimes.push_back(utimes.back() + 200'000 * kSecond);
  const TimeSteps steps = steps_of(utimes);
  EXPECT_EQ(steps.silences.size(), 2U);
  EXPECT_EQ(steps.jumps, 1);
  std::vector<std::int64_t> many;
  for (std::int64_t i = 0; i < 9; ++i) many.push_back(11 * i * kSecond);
  const std::string text = silences_text(steps_of(many));
  EXPECT_NE(text.find(" and 3 more times"), std::string::npos) << text;
}

TEST(SortedByTime, KeepsTheOrderOfWhatHasOneTimeAndNumbersAnew) {
  std::vector<logs::OwnedEvent> events = at({3, 1, 1, 2});
  events[1].data = "first";
  events[2].data = "second";
  const auto sorted = sorted_by_time(logs::views(events));
  EXPECT_EQ(utimes_of(sorted), (std::vector<std::int64_t>{1, 1, 2, 3}));
  EXPECT_EQ(sorted[0].data.text(), "first");
  EXPECT_EQ(sorted[1].data.text(), "second");
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i].number, static_cast<std::int64_t>(i));
}

TEST(Merge, PutsLogsTogetherByTime) {
  const auto one = at({0, 20, 10}, "A");
  const auto other = at({5, 15, 20}, "B");
  const Merge merge = merged({{"one", logs::views(one)}, {"other", logs::views(other)}});
  EXPECT_EQ(utimes_of(merge.events), (std::vector<std::int64_t>{0, 5, 10, 15, 20, 20}));
  EXPECT_EQ(merge.events[4].channel, "A") << "of one time in the inputs' order";
  EXPECT_EQ(merge.late, 1);
  EXPECT_TRUE(merge.remarks.empty());
}

TEST(Merge, SaysThatLogsLieApart) {
  const auto one = at({0, kSecond});
  const auto other = at({11 * kSecond, 12 * kSecond});
  for (const bool turned : {false, true}) {
    const Merge merge = turned ? merged({{"b", logs::views(other)}, {"a", logs::views(one)}})
                               : merged({{"a", logs::views(one)}, {"b", logs::views(other)}});
    ASSERT_EQ(merge.remarks.size(), 1U);
    EXPECT_EQ(merge.remarks[0], std::string(turned ? "b and a" : "a and b") +
                                    " do not overlap: 10.0 s lie between them (if they were recorded together, their "
                                    "clocks differ)");
  }
}

TEST(Merge, KeepsWhatTwoLoggersHeardAndSaysSo) {
  auto one = at({0, 10, 20, 30});
  auto other = at({1, 11, 21, 31});
  for (std::size_t i = 1; i < 3; ++i) other[i].data = one[i].data;
  one[3].data = one[2].data;  // twice in one of them, once in the other
  const Merge merge = merged({{"one", logs::views(one)}, {"other", logs::views(other)}});
  EXPECT_EQ(merge.events.size(), 8U);
  EXPECT_EQ(merge.twice, 2);
  ASSERT_EQ(merge.remarks.size(), 1U);
  EXPECT_EQ(merge.remarks[0].rfind("2 messages stand in more than one of the logs", 0), 0U) << merge.remarks[0];
}

// liblcm's question whether there is a bus stands in every recording.
TEST(Merge, TakesFewMessagesOfOneContentForChance) {
  const auto with = [](std::vector<logs::OwnedEvent> events, const std::string& channel, const std::string& data) {
    events.push_back({0, 50, channel, data});
    return events;
  };
  std::vector<std::int64_t> utimes;
  for (std::int64_t i = 0; i < 30; ++i) utimes.push_back(i);
  const auto one = at(utimes, "A");
  const auto other = at(utimes, "B");
  const auto merge_of = [](const std::vector<logs::OwnedEvent>& a, const std::vector<logs::OwnedEvent>& b) {
    return merged({{"a", logs::views(a)}, {"b", logs::views(b)}});
  };
  EXPECT_EQ(merge_of(with(one, "LCM_SELF_TEST", "lcm self test"), with(other, "LCM_SELF_TEST", "lcm self test")).twice,
            0);
  const Merge chance = merge_of(with(one, "C", "same"), with(other, "C", "same"));
  EXPECT_EQ(chance.twice, 1);
  EXPECT_TRUE(chance.remarks.empty()) << chance.remarks[0];
  const Merge small = merge_of(with({}, "C", "same"), with(other, "C", "same"));
  ASSERT_EQ(small.remarks.size(), 1U);
  EXPECT_EQ(small.remarks[0], "1 message stands in more than one of the logs (one bus, recorded twice?): all are kept");
}

}  // namespace
}  // namespace markservo::log_tool
