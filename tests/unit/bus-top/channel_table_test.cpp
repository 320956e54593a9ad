#include "services/bus-top/channel_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/reflection/message_json.hpp"
#include "common/watch/watch_json.hpp"

namespace markservo::bus_top {
namespace {

using reflection::MessageNote;
using ::testing::HasSubstr;

MessageNote pose(std::int64_t seq) {
  MessageNote note;
  note.bytes = 3;
  note.fingerprint = 7;
  note.type = "TargetPose";
  note.session = 1;
  note.seq = seq;
  return note;
}

TEST(ChannelTable, HasALineForEachChannelByName) {
  watch::BusWatch watch;
  watch.observe("TARGET_POSE", pose(1), "abc", 0.0);
  watch.observe("TARGET_POSE", pose(3), "abc", 0.25);
  watch.observe("TARGET_POSE", pose(4), "abc", 0.5);
  watch.observe("A", pose(1), "abc", 0.0);
  const auto lines = channel_table(watch, 0.7).lines;
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].channel, "A");
  EXPECT_EQ(lines[1].text, "TARGET_POSE  TargetPose     4.0    12 B/s    0.2 s      1           0       1");
  EXPECT_EQ(channel_table(watch, 0.7).heading,
            "channel      type            Hz bandwidth      age   lost undecodable writers");
  EXPECT_TRUE(lines[1].trouble);
  EXPECT_FALSE(lines[0].trouble);
}

TEST(ChannelTable, SaysThatAChannelIsStale) {
  watch::BusWatch watch;
  watch.observe("A", pose(1), "abc", 0.0);
  EXPECT_FALSE(channel_table(watch, 0.5).lines[0].stale);
  EXPECT_TRUE(channel_table(watch, 5.0).lines[0].stale);
  EXPECT_THAT(channel_table(watch, 5.0).lines[0].text, HasSubstr("5.0 s"));
  EXPECT_THAT(channel_table(watch, 5.0).lines[0].text, HasSubstr(" stale"));
}

TEST(ChannelTable, ShowsAForeignTypeByFingerprintAndSize) {
  watch::BusWatch watch;
  MessageNote note;
  note.bytes = 2;
  note.fingerprint = 0xab;
  watch.observe("A", note, "xy", 0.0);
  EXPECT_THAT(channel_table(watch, 0.0).lines[0].text, HasSubstr("0x00000000000000ab (2 B)"));
}

TEST(ChannelTable, LetsNoChannelSpeakToTheTerminal) {
  watch::BusWatch watch;
  watch.observe("A\033[2J\n\xff", pose(1), "abc", 0.0);
  const std::string text = channel_table(watch, 0.0).lines[0].text;
  EXPECT_EQ(text.find_first_of("\033\n\xff"), std::string::npos);
  EXPECT_THAT(text, HasSubstr("A?[2J??"));
}

TEST(SizeText, HasThreeDigits) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1840000), "1.84 MB");
  EXPECT_EQ(size_text(55.2e6), "55.2 MB");
  EXPECT_EQ(size_text(614400), "614 kB");
  EXPECT_EQ(size_text(999600), "1.00 MB");
}

TEST(WatchJson, HasNullForWhatIsNotKnown) {
  watch::BusWatch watch;
  MessageNote note;
  note.bytes = 2;
  watch.observe("A", note, "xy", 0.0);
  const auto json = watch::watch_json(watch, 2.0, 0.5)["channels"][0];
  EXPECT_EQ(json["channel"], "A");
  for (const char* key : {"type", "hash", "hz", "bytes_per_second", "lost"}) EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_EQ(json["age_s"], 0.5);
}

TEST(WatchJson, IsTextWhateverAChannelIsCalled) {
  watch::BusWatch watch;
  watch.observe("A\xff", pose(1), "abc", 0.0);
  EXPECT_NO_THROW(reflection::json_text(watch::watch_json(watch, 2.0, 0.5)));
}

}  // namespace
}  // namespace markservo::bus_top
