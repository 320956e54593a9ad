#include "common/watch/channel_watch.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "common/watch/bus_watch.hpp"

namespace markservo::watch {
namespace {

using reflection::MessageNote;

MessageNote note(std::size_t bytes, std::int64_t session = 0, std::int64_t seq = -1) {
  MessageNote result;
  result.bytes = bytes;
  result.fingerprint = 7;
  result.type = "TargetPose";
  result.session = session;
  result.seq = seq;
  return result;
}

// `count` messages of 100 bytes, `interval` s apart, the first at `start`.
void feed(ChannelWatch& watch, int count, double interval, double start = 0.0) {
  for (int i = 0; i < count; ++i) watch.observe(note(100), start + i * interval);
}

TEST(ChannelWatch, TellsRateAndBandwidthOfARegularChannel) {
  ChannelWatch watch;
  feed(watch, 31, 0.1);
  const ChannelFigures figures = watch.figures(3.05);
  EXPECT_NEAR(figures.hz.value(), 10.0, 1e-9);
  EXPECT_NEAR(figures.bytes_per_second.value(), 1000.0, 1e-6);
  EXPECT_EQ(figures.received, 31);
  EXPECT_EQ(figures.bytes, 3100);
}

TEST(ChannelWatch, FollowsARateThatChanges) {
  ChannelWatch watch;
  feed(watch, 100, 0.1);
  feed(watch, 300, 1.0 / 30.0, 10.0);
  EXPECT_NEAR(watch.figures(20.0).hz.value(), 30.0, 1e-6);
}

TEST(ChannelWatch, KnowsNoRateAfterOneMessageNorAfterALongSilence) {
  ChannelWatch watch;
  watch.observe(note(100), 0.0);
  EXPECT_FALSE(watch.figures(0.1).hz.has_value());
  watch.observe(note(100), 0.1);
  EXPECT_TRUE(watch.figures(0.1).hz.has_value());
  EXPECT_FALSE(watch.figures(60.0).hz.has_value());
  EXPECT_FALSE(watch.figures(60.0).bytes_per_second.has_value());
}

TEST(ChannelWatch, KnowsNoRateOfMessagesAtOneInstant) {
  ChannelWatch watch;
  feed(watch, 3, 0.0);
  EXPECT_FALSE(watch.figures(0.0).hz.has_value());
}

TEST(ChannelWatch, CallsAFastChannelStaleAfterASecond) {
  ChannelWatch watch;
  feed(watch, 11, 0.1);  // until 1.0
  EXPECT_FALSE(watch.figures(1.9).stale);
  EXPECT_TRUE(watch.figures(2.1).stale);
  EXPECT_NEAR(watch.figures(2.1).age, 1.1, 1e-9);
}

TEST(ChannelWatch, CallsASlowChannelStaleAfterThreeOfItsIntervals) {
  ChannelWatch watch;
  feed(watch, 4, 1.0);  // until 3.0
  EXPECT_FALSE(watch.figures(5.9).stale);
  EXPECT_TRUE(watch.figures(6.1).stale);
}

TEST(ChannelWatch, CountsGapsInSeq) {
  ChannelWatch watch;
  for (const std::int64_t seq : {1, 2, 5, 6}) watch.observe(note(10, 1, seq), 0.0);
  EXPECT_EQ(watch.figures(0.0).lost, 2);
}

TEST(ChannelWatch, CountsGapsOfEachWriterAlone) {
  ChannelWatch watch;
  for (const std::int64_t seq : {1, 2, 4, 5}) {
    watch.observe(note(10, 1, seq), 0.0);
    watch.observe(note(10, 2, seq + 100), 0.0);
  }
  EXPECT_EQ(watch.figures(0.0).lost, 2);
  EXPECT_EQ(watch.figures(0.0).writers, 2);
}

TEST(ChannelWatch, CountsNothingForANumberThatLies) {
  ChannelWatch watch;
  for (const std::int64_t seq : {1, 2, 102, 3, 4, 6, 7}) watch.observe(note(10, 1, seq), 0.0);
  EXPECT_EQ(watch.figures(0.0).lost, 1);
}

TEST(ChannelWatch, LosesNothingByRepetitionLatenessOrRestart) {
  ChannelWatch watch;
  for (const std::int64_t seq : {5, 6, 6, 5, 7}) watch.observe(note(10, 1, seq), 0.0);
  watch.observe(note(10, 2, 1), 0.0);
  EXPECT_EQ(watch.figures(0.0).lost, 0);
}

TEST(ChannelWatch, KnowsNoLossOfATypeWithoutSeq) {
  ChannelWatch watch;
  watch.observe(note(10, 1), 0.0);
  EXPECT_FALSE(watch.figures(0.0).lost.has_value());
  EXPECT_EQ(watch.figures(0.0).writers, 1);
}

TEST(ChannelWatch, ForgetsAWriterThatIsGoneButNotThatItWas) {
  ChannelWatch watch;
  watch.observe(note(10, 1, 1), 0.0);
  watch.observe(note(10, 2, 1), 4.0);
  EXPECT_EQ(watch.figures(4.0).writers, 2);
  watch.observe(note(10, 2, 2), 6.0);
  EXPECT_EQ(watch.figures(6.0).writers, 1);
  EXPECT_EQ(watch.figures(6.0).sessions, 2);
}

TEST(ChannelWatch, CountsWhatCannotBeDecoded) {
  ChannelWatch watch;
  MessageNote broken = note(10);
  broken.decodes = false;
  watch.observe(broken, 0.0);
  watch.observe(note(10), 0.0);
  EXPECT_EQ(watch.figures(0.0).undecodable, 1);
}

TEST(ChannelWatch, SurvivesHostileNumbers) {
  ChannelWatch watch;
  constexpr auto kHuge = std::numeric_limits<std::int64_t>::max();
  for (int i = 0; i < 10; ++i) {
    watch.observe(note(10, 1, 0), 0.0);
    watch.observe(note(10, -i - 1, kHuge), 0.0);
    watch.observe(note(10, 1, kHuge), 0.0);
  }
  for (std::int64_t session = 100; session < 10'000; ++session) watch.observe(note(10, session, 0), 0.1);
  EXPECT_EQ(watch.figures(0.1).writers, 64) << "no more are kept";
  EXPECT_EQ(watch.figures(0.1).lost, 0) << "what is no seq";
}

TEST(ChannelWatch, TellsTheRateOfAFlood) {
  ChannelWatch watch;
  feed(watch, 100'000, 1e-5);
  EXPECT_NEAR(watch.figures(1.0).hz.value(), 1e5, 1.0);
}

TEST(BusWatch, KeepsTheNewestMessageOfEachChannel) {
  BusWatch watch;
  watch.observe("A", note(2), "ab", 0.0);
  watch.observe("B", note(1), "x", 0.0);
  watch.observe("A", note(3), "cde", 1.0);
  ASSERT_NE(watch.find("A"), nullptr);
  EXPECT_EQ(watch.find("A")->newest, (std::vector<std::uint8_t>{'c', 'd', 'e'}));
  EXPECT_EQ(watch.find("C"), nullptr);
}

TEST(BusWatch, OnlyCountsChannelsBeyondTheLimit) {
  BusWatch watch;
  for (std::size_t i = 0; i < BusWatch::kMaxChannels + 5; ++i) {
    watch.observe("C" + std::to_string(i), note(1), "x", 0.0);
  }
  EXPECT_EQ(watch.channels().size(), BusWatch::kMaxChannels);
  EXPECT_EQ(watch.unwatched(), 5);
}

}  // namespace
}  // namespace markservo::watch
