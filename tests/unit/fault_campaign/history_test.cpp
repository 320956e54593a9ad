#include "tests/system/fault_campaign/history.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/system/fault_campaign/multicast_bus.hpp"

namespace markservo::campaign {
namespace {

class HistoryOnDisk : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "fault-history-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

TEST_F(HistoryOnDisk, ComesBackAsItWasWritten) {
  {
    HistoryWriter writer(folder_);
    const std::vector<std::uint8_t> data{1, 2, 3};
    const std::vector<std::uint8_t> large(100'000, 7);
    writer.heard(10, "A", 3, data.data(), data.size());
    writer.heard(20, "B", 100'000, large.data(), large.size());
    writer.fact(30, {{"kind", "phase"}, {"phase", "idle"}});
  }
  const History history = load_history(folder_);
  ASSERT_EQ(history.events.size(), 2U);
  EXPECT_EQ(history.events[0].channel, "A");
  EXPECT_TRUE(history.events[0].whole());
  EXPECT_EQ(history.events[1].channel, "B");
  EXPECT_EQ(history.events[1].size, 100'000);
  EXPECT_FALSE(history.events[1].whole());
  ASSERT_EQ(history.facts.size(), 1U);
  EXPECT_EQ(history.facts[0].at("t"), 30);
}

TEST_F(HistoryOnDisk, TellsTheTrialsOwnMessagesFromTheStacks) {
  {
    HistoryWriter writer(folder_);
    const std::vector<std::uint8_t> data{1, 2, 3};
    writer.heard(10, "A", 3, data.data(), data.size());  // the stack's, before
    writer.sent(20, "A", data);
    writer.heard(21, "A", 3, data.data(), data.size());
    writer.heard(40, "A", 3, data.data(), data.size());  // the stack's, once more
  }
  const History history = load_history(folder_);
  ASSERT_EQ(history.events.size(), 3U);
  EXPECT_FALSE(history.events[0].foreign);
  EXPECT_TRUE(history.events[1].foreign);
  EXPECT_FALSE(history.events[2].foreign);
}

TEST(Datagram, ComesBackFromBothOfLcmsFormats) {
  const std::vector<std::uint8_t> data{9, 8, 7};
  const auto small = short_datagram(1, "STOP", data);
  const HeardMessage heard = parse_datagram(small.data(), small.size());
  EXPECT_EQ(heard.channel, "STOP");
  EXPECT_EQ(heard.size, 3);
  const auto first = fragment_datagram(2, 5000, 0, 0, 2, "BIG", data.data(), data.size());
  const HeardMessage piece = parse_datagram(first.data(), first.size());
  EXPECT_EQ(piece.channel, "BIG");
  EXPECT_EQ(piece.size, 5000);
  EXPECT_EQ(piece.available, 3U);
  const auto later = fragment_datagram(2, 5000, 3, 1, 2, "BIG", data.data(), data.size());
  EXPECT_TRUE(parse_datagram(later.data(), later.size()).channel.empty());
}

TEST(Datagram, OfOthersIsNone) {
  const std::vector<std::uint8_t> bytes{'L', 'C', '0', '2', 0, 0, 0, 0, 'A'};  // the name never ends
  EXPECT_TRUE(parse_datagram(bytes.data(), bytes.size()).channel.empty());
  EXPECT_TRUE(parse_datagram(bytes.data(), 3).channel.empty());
}

}  // namespace
}  // namespace markservo::campaign
