#include <gtest/gtest.h>
#include <unistd.h>
#include <markservo/TargetPose.hpp>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/command.hpp"
#include "tests/unit/log-tool/log_bytes.hpp"
#include "tests/unit/log_events.hpp"

namespace markservo::log_tool {
namespace {

namespace fs = std::filesystem;
using test::CommandResult;

class LogTool : public ::testing::Test {
 protected:
  LogTool() { fs::create_directory(folder_); }
  ~LogTool() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ + "/" + name; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  std::string read(const std::string& name) const {
    std::stringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }
  static CommandResult run(const std::string& arguments) {
    return test::run_command(std::string(MARKSERVO_BIN_DIR) + "/log-tool " + arguments);
  }

  std::string folder_ = fs::temp_directory_path() / ("log_tool_command_test." + std::to_string(getpid()));
  std::mt19937 random_{3};
  std::vector<OwnedEvent> events_ = mixed_events(30, random_);
  std::string bytes_ = log_bytes(events_);
};

TEST_F(LogTool, SaysInOneLineWhatIsNoLog) {
  write("empty", "");
  write("text", "This is not a log.\n");
  fs::create_directory(path("folder"));
  for (const auto& [name, why] :
       std::vector<std::pair<std::string, std::string>>{{"empty", "is empty"},
                                                        {"text", "no event is found in its 19 bytes"},
                                                        {"folder", "holds no log.lcm"},
                                                        {"absent", "No such file or directory"}}) {
    const CommandResult result = run("info " + path(name));
    EXPECT_EQ(result.exit_code, 2) << name;
    EXPECT_NE(result.output.find(path(name) + ": " + why + "; allowed: "), std::string::npos) << result.output;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
}

TEST_F(LogTool, SaysThatALogMayNotBeRead) {
  write("log", bytes_);
  fs::permissions(path("log"), fs::perms::none);
  // Root may read all: then somebody else asks.
  const std::string who = geteuid() == 0 ? "setpriv --reuid=65534 --clear-groups " : "";
  fs::permissions(folder_, fs::perms::all);
  const CommandResult result = test::run_command("cd / && cp " MARKSERVO_BIN_DIR "/log-tool " + path("tool") + " && " +
                                                 who + path("tool") + " info " + path("log"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find(path("log") + ": Permission denied; allowed: an LCM log"), std::string::npos)
      << result.output;
}

TEST_F(LogTool, ShowsTypesThatItDoesNotKnowByFingerprintAndSize) {
  write("log", bytes_);
  const CommandResult result = run("info --json " + path("log"));
  EXPECT_EQ(result.exit_code, 0);
  const auto json = nlohmann::json::parse(result.output);
  ASSERT_EQ(json["channels"].size(), 3U);
  EXPECT_EQ(json["channels"][0]["channel"], "BIG");
  EXPECT_TRUE(json["channels"][0]["type"].is_null());
  EXPECT_EQ(json["channels"][0]["hash"].get<std::string>().size(), 18U);
  EXPECT_GT(json["channels"][0]["bytes"], 20'000);
  EXPECT_EQ(json["channels"][2]["type"], "TargetPose");
  EXPECT_EQ(json["channels"][2]["lost"], 0);
  EXPECT_NE(run("info " + path("log")).output.find("TARGET_POSE  TargetPose"), std::string::npos);
}

TEST_F(LogTool, ExplainsTheWordsOfItsTableWhereTheyStand) {
  const auto pose = [](std::int64_t number, std::int64_t utime, std::int64_t session, std::int64_t seq) {
    return OwnedEvent{number, 1000 * number, "TARGET_POSE", payload(target_pose(utime, session, seq))};
  };
  const auto explains = [&](const std::vector<OwnedEvent>& events, const std::string& word) {
    write("log", log_bytes(events));
    return run("info " + path("log")).output.find("\n\n" + word + ": ") != std::string::npos;
  };
  for (const char* word : {"lost", "sessions", "back in time"}) {
    EXPECT_FALSE(explains({pose(1, 1000, 7, 1), pose(2, 2000, 7, 2)}, word)) << word;
  }
  EXPECT_TRUE(explains({pose(1, 1000, 7, 1), pose(2, 2000, 7, 3), pose(3, 3000, 7, 4)}, "lost"));
  EXPECT_TRUE(explains({pose(1, 1000, 7, 1), pose(2, 2000, 8, 1)}, "sessions"));
  EXPECT_TRUE(explains({pose(1, 2000, 7, 1), pose(2, 1000, 7, 2)}, "back in time"));
}

TEST_F(LogTool, RepairsALogSoThatLiblcmReadsItToItsEnd) {
  bytes_[log_bytes({events_[0], events_[1]}).size() + 2] ^= 1;
  write("damaged", bytes_);
  EXPECT_LT(test::events_of(path("damaged")).size(), 3U) << "liblcm stops";
  const CommandResult verdict = run("verify " + path("damaged"));
  EXPECT_EQ(verdict.exit_code, 1);
  EXPECT_NE(verdict.output.find("30 events can be read"), std::string::npos) << verdict.output;
  EXPECT_EQ(run("repair " + path("damaged") + " " + path("repaired")).exit_code, 0);
  EXPECT_EQ(test::events_of(path("repaired")).size(), 30U);
  EXPECT_EQ(run("verify " + path("repaired")).exit_code, 0);
  EXPECT_EQ(run("repair " + path("damaged") + " " + path("repaired")).exit_code, 2) << "nothing is overwritten";
}

TEST_F(LogTool, LeavesNoHalfALogOnAFullDisk) {
  write("log", bytes_);
  const CommandResult result =
      test::run_command("bash -c 'trap \"\" XFSZ; ulimit -f 8; " MARKSERVO_BIN_DIR "/log-tool cut " + path("log") +
                        " " + path("part") + "'");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find(path("part") + ": cannot be written"), std::string::npos) << result.output;
  EXPECT_FALSE(fs::exists(path("part")));
}

TEST_F(LogTool, ReadsTheConfigurationOutOfARecordingAndNothingOutsideItsFolder) {
  fs::create_directory(path("recording"));
  write("recording/manifest.json",
        R"({"configuration": {"files": [{"path": "config/robot.yaml", "sha256": "", "text": "arm: {}\n"}]}})");
  EXPECT_EQ(run("extract-config " + path("recording") + " " + path("out")).exit_code, 0);
  EXPECT_EQ(read("out/config/robot.yaml"), "arm: {}\n");
  EXPECT_EQ(run("extract-config " + path("recording") + " " + path("out")).exit_code, 2) << "nothing is overwritten";
  write("recording/manifest.json", R"({"configuration": {"files": [{"path": "../evil", "text": "x"}]}})");
  EXPECT_EQ(run("extract-config " + path("recording") + " " + path("out2")).exit_code, 2);
  EXPECT_FALSE(fs::exists(path("evil")));
  write("recording/manifest.json", "{");
  EXPECT_NE(run("extract-config " + path("recording") + " " + path("out3")).output.find("no manifest"),
            std::string::npos);
}

TEST_F(LogTool, ReadsNoPipeAndDoesNotWaitForOne) {
  ASSERT_EQ(test::run_command("mkfifo " + path("pipe")).exit_code, 0);
  const CommandResult result = run("info " + path("pipe"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find("is no regular file"), std::string::npos) << result.output;
}

TEST_F(LogTool, SpeaksInTheNameThatWasTyped) {
  const auto typed = [](const std::string& name, const std::string& arguments) {
    return test::run_command("bash -c \"exec -a '" + name + "' " MARKSERVO_BIN_DIR "/log-tool " + arguments + "\"");
  };
  EXPECT_EQ(typed("scripts/log", "info").output, "log: LOG is required; see scripts/log --help\n");
  EXPECT_EQ(typed("markservo log", "info").output, "log: LOG is required; see markservo log --help\n");
  EXPECT_EQ(run("info").output, "log-tool: LOG is required; see log-tool --help\n");
  EXPECT_EQ(typed("markservo replay", "info /absent").output.rfind("replay: /absent: ", 0), 0U);
  EXPECT_NE(typed("markservo log", "info --help").output.find("Usage: markservo log info "), std::string::npos);
}

TEST_F(LogTool, ShowsWhatIsLeftOfALogWithADamagedNameAndFingerprint) {
  events_[1].channel = "OTH\xff\x1b]0;";
  events_[0].data[3] = '\x55';
  write("log", log_bytes(events_));
  const auto json = nlohmann::json::parse(run("info --json " + path("log")).output);
  ASSERT_EQ(json["channels"].size(), 4U);
  for (const auto& channel : json["channels"]) {
    if (channel["channel"] != "TARGET_POSE") continue;
    EXPECT_EQ(channel["type"], "TargetPose");
    EXPECT_EQ(channel["other_types"], 1);
  }
  const std::string table = run("info " + path("log")).output;
  EXPECT_NE(table.find("OTH??]0;"), std::string::npos) << table;
  EXPECT_EQ(table.find('\x1b'), std::string::npos);
}

TEST_F(LogTool, TakesOnlyTheLoggersOwnFilesForPartsOfARecording) {
  fs::create_directory(path("recording"));
  write("recording/log.lcm.00", bytes_);
  write("recording/log.lcm.fixed", bytes_);
  EXPECT_EQ(nlohmann::json::parse(run("info --json " + path("recording")).output)["events"], 30);
}

TEST_F(LogTool, GivesChannelsThatWouldShareAFileTheirOwn) {
  events_[0].channel = "a/b";
  events_[3].channel = "a_b";
  write("log", log_bytes(events_));
  EXPECT_EQ(run("export " + path("log") + " " + path("tables")).exit_code, 0);
  EXPECT_TRUE(fs::exists(path("tables/a_b.csv")));
  EXPECT_TRUE(fs::exists(path("tables/a_b.2.csv")));
}

TEST_F(LogTool, WritesATablePerChannel) {
  write("log", bytes_);
  const CommandResult result = run("export " + path("log") + " " + path("tables"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  const std::string table = read("tables/TARGET_POSE.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 11);
  EXPECT_EQ(table.rfind("log_utime,utime,session,seq,", 0), 0U);
  EXPECT_EQ(run("export " + path("log") + " " + path("tables")).exit_code, 2) << "nothing is overwritten";
  EXPECT_NE(result.output.find("BIG: left out, 10 messages of unknown type 0x"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace markservo::log_tool
