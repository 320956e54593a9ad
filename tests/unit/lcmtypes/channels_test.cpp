// The table of channels: what it must never lose, and what the build refuses.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <markservo/channels.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tests/unit/command.hpp"

namespace markservo::channels {
namespace {

std::set<std::string> names_where(bool Entry::*flag) {
  std::set<std::string> names;
  for (const Entry& entry : kAll) {
    if (entry.*flag) names.insert(entry.name);
  }
  return names;
}

TEST(Channels, NamesAllThatMakesARobotMoveOrReleasesIt) {
  EXPECT_EQ(names_where(&Entry::moves_robot),
            (std::set<std::string>{"BASE_COMMAND", "BASE_GOAL", "JOINT_COMMAND", "SERVO_GOAL", "SIM_CONTROL", "STOP",
                                   "TASK_COMMAND"}));
}

TEST(Channels, WhatMovesARobotFeedsMotionToo) {
  for (const Entry& entry : kAll) EXPECT_TRUE(entry.feeds_motion || !entry.moves_robot) << entry.name;
}

TEST(Channels, OnlyPicturesTruthAndWordsFeedNoMotion) {
  std::set<std::string> harmless;
  for (const Entry& entry : kAll) {
    if (!entry.feeds_motion) harmless.insert(entry.name);
  }
  EXPECT_EQ(harmless, (std::set<std::string>{"LEARN_RESULT", "PROCESS_STATUS", "RECORDER_STATUS", "SERVICE_STATUS",
                                             "SIM_BASE_TRUTH", "SIM_TRUTH", "STEREO_MATCHES", "TASK_STATE"}));
}

TEST(Channels, NoTypeBothMovesAndDoesNot) {
  for (const Entry& one : kAll) {
    for (const Entry& other : kAll) {
      if (std::string(one.type) != other.type) continue;
      EXPECT_EQ(one.moves_robot, other.moves_robot) << one.name;
    }
  }
}

TEST(Channels, AreFoundByTheirWholeName) {
  ASSERT_NE(find("STOP"), nullptr);
  EXPECT_STREQ(find("STOP")->type, "StopRequest");
  EXPECT_STREQ(find("STOP_STATE")->type, "StopState");
  EXPECT_EQ(find("STOPS"), nullptr);
  EXPECT_EQ(find("STO"), nullptr);
  EXPECT_EQ(find("r1/STOP"), nullptr);
  EXPECT_EQ(find(""), nullptr);
}

// Runs the build's generator on the project's table with one text replaced.
class GenerateChannels : public ::testing::Test {
 protected:
  GenerateChannels() { std::filesystem::create_directory(folder_); }
  ~GenerateChannels() override { std::filesystem::remove_all(folder_); }

  test::CommandResult generate(const std::string& text, const std::string& types = all_types()) const {
    std::ofstream(folder_ / "channels.yaml") << text;
    return test::run_command("cd " + folder_.string() +
                             " && " MARKSERVO_BIN_DIR "/generate_channels channels.yaml channels.hpp " + types);
  }

  void expect_refused(const std::string& text, const std::string& why) const {
    const test::CommandResult result = generate(text);
    EXPECT_EQ(result.exit_code, 2) << why;
    EXPECT_NE(result.output.find(why), std::string::npos) << result.output << "lacks: " << why;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "channels.hpp")) << why;
  }

  // The project's table with the first `text` after "channel:" replaced.
  static std::string with(const std::string& channel, const std::string& text, const std::string& instead) {
    std::ostringstream words;
    words << std::ifstream(MARKSERVO_SOURCE_DIR "/lcmtypes/channels.yaml").rdbuf();
    std::string table = words.str();
    const std::size_t at = table.find(text, table.find("\n" + channel + ":"));
    if (at == std::string::npos) throw std::invalid_argument(channel + " has no " + text);
    return table.replace(at, text.size(), instead);
  }

  static std::string all_types() {
    std::string types;
    for (const Entry& entry : kAll) types += std::string(entry.type) + " ";
    return types;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("channels_test." + std::to_string(getpid()));
};

TEST_F(GenerateChannels, WritesWhatTheBuildUses) {
  const test::CommandResult result = generate(with("STOP", "type", "type"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  std::ostringstream header;
  header << std::ifstream(folder_ / "channels.hpp").rdbuf();
  EXPECT_NE(header.str().find("inline constexpr Channel<StopRequest> kStop{"), std::string::npos);
  EXPECT_EQ(header.str().find("#include <markservo/"), std::string::npos) << "an object would depend on every type";
}

TEST_F(GenerateChannels, RefusesWhatIsNotAllowedNamingFileKeyValueAndAllowed) {
  expect_refused(with("STOP", "second: allowed", "second: many"),
                 "STOP.second is 'many'; allowed: allowed, ignored, hold");
  expect_refused(with("STOP", "moves_robot: true", "moves_robot: yes"),
                 "STOP.moves_robot is 'yes'; allowed: true, false");
  expect_refused(with("STOP", "type: StopRequest", "type: StopRequests"), "STOP.type is 'StopRequests'; allowed: ");
  expect_refused(with("STOP", "repeat: until_echoed", "repeat: 5"),
                 "STOP.repeat is '5'; allowed: none, steadily, until_echoed");
  expect_refused(with("BASE_COMMAND", "[base-navigator]", "[Base_Navigator]"),
                 "BASE_COMMAND.writers is 'Base_Navigator'; allowed: ");
  expect_refused(with("BASE_COMMAND", "[base-navigator]", "base-navigator"),
                 "BASE_COMMAND.writers is no list; allowed: ");
  expect_refused(with("STOP", "what: stops", "what: \"\\\"\" #"), "STOP.what is '\"'; allowed: ");
  expect_refused(with("STOP", "STOP:", "Stop:"), "Stop is a channel's name; allowed: A to Z, 0 to 9 and _");
}

TEST_F(GenerateChannels, NamesTheLine) {
  expect_refused("A_CHANNEL:\n  type: None\n", "channels.yaml:2: A_CHANNEL.type is 'None'; allowed: ");
}

TEST_F(GenerateChannels, RefusesWhatIsMissingUnknownOrDoubled) {
  expect_refused(with("STOP", "  moves_robot: true\n", ""), "STOP.moves_robot is missing; allowed: every key is given");
  expect_refused(with("STOP", "  moves_robot: true\n", "  moves_robot: true\n  moves: true\n"),
                 "STOP.moves is unknown; allowed: ");
  expect_refused(with("STOP", "  moves_robot: true\n", "  moves_robot: true\n  moves_robot: false\n"),
                 "STOP.moves_robot is given twice; allowed: once");
  expect_refused(with("STOP_STATE", "STOP_STATE:", "STOP:"), "STOP is given twice; allowed: once");
}

TEST_F(GenerateChannels, RefusesWhatIsNoTable) {
  expect_refused("", "channels.yaml: holds no channels; allowed: ");
  expect_refused("A: [", "channels.yaml: ");
  expect_refused("A_CHANNEL: 1", "channels.yaml:1: A_CHANNEL is no keys; allowed: ");
}

}  // namespace
}  // namespace markservo::channels
