#include "common/census/census.hpp"

#include <gtest/gtest.h>

#include <cstdint>

#include "common/census/census_text.hpp"

namespace markservo::census {
namespace {

constexpr std::int64_t kBegin_us = 1'700'000'000'000'000;
constexpr std::int64_t kSecond_us = 1'000'000;

Heard message(const std::string& channel, std::int64_t at_us, std::int64_t session, std::int64_t seq) {
  Heard heard;
  heard.channel = channel;
  heard.hash = 7;
  heard.type = "Kind";
  heard.bytes = 100;
  heard.utime = kBegin_us + at_us;
  heard.session = session;
  heard.seq = seq;
  return heard;
}

ServiceWord word(const std::string& name, int pid, std::int64_t session, std::int64_t at_us) {
  ServiceWord word;
  word.name = name;
  word.host = "here";
  word.pid = pid;
  word.session = session;
  word.state = "ready";
  word.utime = kBegin_us + at_us;
  return word;
}

// `events` messages at 10 Hz.
void hear_stream(Census& census, const std::string& channel, int events, std::int64_t session) {
  for (int i = 0; i < events; ++i) census.observe(message(channel, i * 100'000, session, i + 1));
}

ChannelReport channel_of(const Census& census, const std::string& name) {
  for (const ChannelReport& channel : census.report(kBegin_us + 2 * kSecond_us).channels) {
    if (channel.channel == name) return channel;
  }
  return {};
}

TEST(Census, TellsRateAndBytesOfAChannel) {
  Census census(kBegin_us);
  hear_stream(census, "POSE", 16, 5);
  const ChannelReport pose = channel_of(census, "POSE");
  EXPECT_NEAR(pose.hz, 10.0, 1e-9);
  EXPECT_NEAR(pose.bytes_per_s, 1000.0, 1e-6);
  EXPECT_EQ(pose.events, 16);
  EXPECT_EQ(pose.type, "Kind");
}

TEST(Census, TakesTheWholeSpanForTheRateOfAFewMessages) {
  Census census(kBegin_us);
  hear_stream(census, "POSE", 2, 5);
  EXPECT_NEAR(channel_of(census, "POSE").hz, 1.0, 1e-9);
}

TEST(Census, CountsGapsInTheNumbersAsLost) {
  Census census(kBegin_us);
  census.observe(message("POSE", 0, 5, 1));
  for (const std::int64_t seq : {4, 5}) census.observe(message("POSE", seq, 5, seq));
  EXPECT_EQ(channel_of(census, "POSE").lost, 2);
}

TEST(Census, KnowsARestartedWriterFromASecondOne) {
  Census census(kBegin_us);
  census.observe(message("POSE", 0, 5, 1));
  census.observe(message("POSE", 1, 6, 1));
  EXPECT_FALSE(channel_of(census, "POSE").two_writers);
  census.observe(message("POSE", 2, 5, 2));
  EXPECT_TRUE(channel_of(census, "POSE").two_writers);
  EXPECT_EQ(channel_of(census, "POSE").writers.size(), 2U);
}

TEST(Census, AllowsManyWritersWhereManyMayWrite) {
  for (const char* channel : {"STOP", "r1/STOP_STATE", "SERVICE_STATUS"}) {
    Census census(kBegin_us);
    for (const std::int64_t session : {5, 6, 5}) census.observe(message(channel, 0, session, 1));
    EXPECT_FALSE(channel_of(census, channel).two_writers) << channel;
  }
}

TEST(Census, NoticesAChannelThatChangesItsType) {
  Census census(kBegin_us);
  hear_stream(census, "POSE", 3, 5);
  EXPECT_FALSE(channel_of(census, "POSE").several_types);
  Heard other = message("POSE", 9, 5, 4);
  other.hash = 8;
  census.observe(other);
  EXPECT_TRUE(channel_of(census, "POSE").several_types);
}

TEST(Census, NamesWhoWritesAnotherVersionOfAType) {
  Census census(kBegin_us);
  hear_stream(census, "POSE", 3, 5);
  Heard other;
  other.channel = "POSE";
  other.hash = 8;
  other.utime = kBegin_us;
  other.other_version = OtherVersion{"Kind", 7, 6};
  census.observe(other);
  census.observe(other);
  census.observe(word("locator", 10, 6, 0), kBegin_us + 100);
  const ChannelReport pose = channel_of(census, "POSE");
  ASSERT_EQ(pose.other_versions.size(), 1U);
  EXPECT_EQ(pose.other_versions[0].service, "locator");
  EXPECT_EQ(pose.other_versions[0].events, 2);
  EXPECT_EQ(pose.other_versions[0].hash, 8);
  EXPECT_EQ(pose.other_versions[0].our_hash, 7);
  EXPECT_FALSE(pose.two_writers) << "what it says of its writer may be invented";
}

TEST(Census, ForgetsOtherVersionsWhereThereAreTooMany) {
  Census census(kBegin_us);
  for (std::int64_t session = 1; session < 1000; ++session) {
    Heard other;
    other.channel = "POSE";
    other.other_version = OtherVersion{"Kind", 7, session};
    census.observe(other);
  }
  EXPECT_LE(channel_of(census, "POSE").other_versions.size(), 8U);
}

TEST(Census, CountsWhatItCannotDecode) {
  Census census(kBegin_us);
  Heard unknown;
  unknown.channel = "STRANGE";
  unknown.utime = kBegin_us;
  census.observe(unknown);
  EXPECT_EQ(channel_of(census, "STRANGE").events, 1);
  EXPECT_TRUE(channel_of(census, "STRANGE").writers.empty());
}

TEST(Census, NamesTheServiceThatWritesAChannel) {
  Census census(kBegin_us);
  hear_stream(census, "POSE", 3, 5);
  hear_stream(census, "SERVICE_STATUS", 1, 5);
  census.observe(word("locator", 10, 5, 0), kBegin_us + 100);
  const Report report = census.report(kBegin_us + kSecond_us);
  ASSERT_EQ(report.services.size(), 1U);
  EXPECT_EQ(report.services[0].writes, std::vector<std::string>{"POSE"});
  EXPECT_EQ(report.channels[0].writers[0].service, "locator");
}

TEST(Census, NamesTwoProcessesThatSpeakInTurn) {
  Census census(kBegin_us);
  for (const std::int64_t at : {0, 1}) {
    census.observe(word("locator", 10, 5, at), kBegin_us + at);
    census.observe(word("locator", 11, 6, at), kBegin_us + at);
  }
  const Report report = census.report(kBegin_us + kSecond_us);
  ASSERT_EQ(report.services.size(), 2U);
  EXPECT_TRUE(report.services[0].duplicate);
  EXPECT_TRUE(report.services[1].duplicate);
}

TEST(Census, AllowsARestartAndTheSameNameOfAnotherRobot) {
  Census census(kBegin_us);
  census.observe(word("locator", 10, 5, 0), kBegin_us);
  census.observe(word("locator", 11, 6, 1), kBegin_us + 1);
  ServiceWord other = word("locator", 12, 7, 2);
  other.robot = "r2";
  census.observe(other, kBegin_us + 2);
  census.observe(word("locator", 11, 6, 3), kBegin_us + 3);
  for (const ServiceReport& service : census.report(kBegin_us + kSecond_us).services) EXPECT_FALSE(service.duplicate);
}

TEST(Census, TellsHowFarAnotherClockIsOffByTheQuickestMessage) {
  Census census(kBegin_us);
  census.observe(word("locator", 10, 5, 1'000'000), kBegin_us + 400'000);  // sent 0.6 s ahead of our clock
  census.observe(word("locator", 10, 5, 2'000'000), kBegin_us + 1'500'000);
  const Report report = census.report(kBegin_us + 2 * kSecond_us);
  EXPECT_NEAR(report.services[0].clock_behind_s, -0.6, 1e-9);
  EXPECT_NEAR(report.services[0].silent_s, 0.5, 1e-9);
  EXPECT_EQ(report.services[0].heard, 2);
}

TEST(Census, BelievesTheProcessThatIsKnownOfTwoThatClaimOneSession) {
  for (const bool known_speaks_first : {true, false}) {
    Census census(kBegin_us);
    census.observe({"here", {{"locator", 10}}});
    if (known_speaks_first) census.observe(word("locator", 10, 5, 0), kBegin_us);
    for (const std::int64_t at : {1, 2, 3}) census.observe(word("liar", 99, 5, at), kBegin_us + at);
    if (!known_speaks_first) census.observe(word("locator", 10, 5, 4), kBegin_us + 4);
    hear_stream(census, "POSE", 3, 5);
    const Report report = census.report(kBegin_us + kSecond_us);
    EXPECT_EQ(report.channels.at(0).writers.at(0).service, "locator");
    for (const ServiceReport& service : report.services) EXPECT_EQ(service.writes.empty(), service.newest.pid == 99);
  }
}

TEST(Census, KeepsABoundedNumberOfWritersAndOfChannelsThatServicesTellOf) {
  Census census(kBegin_us);
  std::size_t writers = 0;
  std::size_t words = 0;
  for (int i = 0; i < 1000; ++i) {
    ServiceWord talkative = word("x" + std::to_string(i), i, 1000 + i, 0);
    talkative.channels.resize(500);
    census.observe(talkative, kBegin_us);
    for (int session = 1; session <= 100; ++session) census.observe(message("C" + std::to_string(i), 0, session, 1));
  }
  const Report report = census.report(kBegin_us + kSecond_us);
  for (const ChannelReport& channel : report.channels) writers += channel.writers.size();
  for (const ServiceReport& service : report.services) words += service.newest.channels.size();
  EXPECT_LE(writers, 16384U);
  EXPECT_LE(words, 16384U);
}

TEST(Census, IsReadyOnlyWhenItWaitsForNothing) {
  for (const char* state : {"starting", "waiting", "stale"}) EXPECT_FALSE(is_ready(state)) << state;
  for (const char* state : {"ready", "stopped", "idle", "real time"}) EXPECT_TRUE(is_ready(state)) << state;
}

TEST(CensusText, KeepsControlCharactersOffTheTerminal) {
  Census census(kBegin_us);
  ServiceWord hostile = word("evil\x1b[2J", 1, 2, 0);
  hostile.reason = "a\nb";
  census.observe(hostile, kBegin_us);
  const std::string table = table_of(census.report(kBegin_us + kSecond_us));
  EXPECT_EQ(table.find('\x1b'), std::string::npos);
  EXPECT_NE(table.find("a?b"), std::string::npos);
}

TEST(CensusText, GivesSessionsWithAllTheirBits) {
  Census census(kBegin_us);
  census.observe(word("locator", 10, 0x7fffffffffffffff, 0), kBegin_us);
  EXPECT_EQ(json_of(census.report(kBegin_us + kSecond_us))["services"][0]["session"], "0x7fffffffffffffff");
}

TEST(CensusText, SaysThatNobodyIsThere) {
  EXPECT_NE(table_of(Census(kBegin_us).report(kBegin_us + kSecond_us)).find("nobody"), std::string::npos);
}

}  // namespace
}  // namespace markservo::census
