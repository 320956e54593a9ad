#include <gtest/gtest.h>
#include <unistd.h>
#include <markservo/TargetPose.hpp>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/unit/command.hpp"
#include "tests/unit/log_events.hpp"
#include "tests/unit/logs/log_bytes.hpp"

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
  std::vector<logs::OwnedEvent> events_ = logs::mixed_events(30, random_);
  std::string bytes_ = logs::log_bytes(events_);
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
  // Root may read all, by these capabilities.
  const std::string as_others = geteuid() == 0 ? "setpriv --inh-caps=-all --ambient-caps=-all "
                                                 "--bounding-set=-dac_override,-dac_read_search "
                                               : "";
  const CommandResult result = test::run_command(as_others + MARKSERVO_BIN_DIR "/log-tool info " + path("log"));
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
    return logs::OwnedEvent{number, 1000 * number, "TARGET_POSE",
                            logs::payload(logs::target_pose(utime, session, seq))};
  };
  const auto explains = [&](const std::vector<logs::OwnedEvent>& events, const std::string& word) {
    write("log", logs::log_bytes(events));
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
  bytes_[logs::log_bytes({events_[0], events_[1]}).size() + 2] ^= 1;
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
  write("log", logs::log_bytes(events_));
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
  write("log", logs::log_bytes(events_));
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

// Two channels in turn every 0.1 s, as another system writes them.
std::vector<logs::OwnedEvent> two_channels(int count) {
  std::vector<logs::OwnedEvent> events;
  for (int i = 0; i < count; ++i) {
    events.push_back(
        {i, 1'700'000'000'000'000 + std::int64_t{100'000} * i, i % 2 == 0 ? "A" : "B", "message " + std::to_string(i)});
  }
  return events;
}

// How the log's order is told, and what sorting makes of it.
class Order : public LogTool {
 protected:
  nlohmann::json info_of(const std::vector<logs::OwnedEvent>& events) const {
    write("log", logs::log_bytes(events));
    return nlohmann::json::parse(run("info --json " + path("log")).output);
  }
  // The sorted log's payloads, one behind the other.
  std::string sorted() const {
    fs::remove(path("sorted"));
    EXPECT_EQ(run("sort " + path("log") + " " + path("sorted")).exit_code, 0);
    EXPECT_EQ(nlohmann::json::parse(run("info --json " + path("sorted")).output)["non_monotonic"], 0);
    std::string payloads;
    for (const auto& [channel, payload] : test::events_of(path("sorted"))) payloads += payload + ",";
    return payloads;
  }
  static std::string payloads_of(const std::vector<logs::OwnedEvent>& events) {
    std::string payloads;
    for (const logs::OwnedEvent& event : events) payloads += event.data + ",";
    return payloads;
  }
};

TEST_F(Order, OfALogWhoseSecondHalfStandsFirstIsToldAndMended) {
  const auto events = two_channels(40);
  auto turned = events;
  std::rotate(turned.begin(), turned.begin() + 20, turned.end());
  for (std::size_t i = 0; i < turned.size(); ++i) turned[i].number = static_cast<std::int64_t>(i);
  const auto json = info_of(turned);
  EXPECT_EQ(json["events"], 40);
  EXPECT_DOUBLE_EQ(json["seconds"], 3.9);
  EXPECT_EQ(json["steps_back"], 1);
  EXPECT_DOUBLE_EQ(json["farthest_back_s"], 3.9);
  EXPECT_EQ(json["non_monotonic"], 20);
  EXPECT_EQ(json["disorder"], "1 time back, by 3.9 s: 20 events are out of order");
  const std::string text = run("info " + path("log")).output;
  EXPECT_NE(text.find("time goes 1 time back, by 3.9 s: 20 events are out of order"), std::string::npos) << text;
  EXPECT_EQ(sorted(), payloads_of(events));
}

TEST_F(Order, OfARecordingWithLargeMessagesIsNotWorthAWord) {
  auto events = two_channels(40);
  events[20].utime -= 150'000;  // 50 ms earlier than the one before
  const auto json = info_of(events);
  EXPECT_EQ(json["non_monotonic"], 1) << "programs are told";
  EXPECT_EQ(json["disorder"], "");
  const std::string text = run("info " + path("log")).output;
  EXPECT_EQ(text.find("time goes"), std::string::npos) << text;
}

TEST_F(Order, OfEveryChannelBehindTheOtherIsToldAndMended) {
  const auto events = two_channels(40);
  auto by_channel = events;
  std::stable_sort(by_channel.begin(), by_channel.end(),
                   [](const logs::OwnedEvent& a, const logs::OwnedEvent& b) { return a.channel < b.channel; });
  const auto json = info_of(by_channel);
  EXPECT_EQ(json["steps_back"], 1);
  EXPECT_NEAR(json["farthest_back_s"], 3.7, 1e-9);
  EXPECT_EQ(json["non_monotonic"], 19);
  EXPECT_EQ(sorted(), payloads_of(events));
}

TEST_F(Order, OfAClockThatWasSetBackIsToldAndKeptUnlessSorted) {
  auto events = two_channels(40);
  for (std::size_t i = 20; i < events.size(); ++i) events[i].utime -= std::int64_t{3600} * 1'000'000;
  const auto json = info_of(events);
  EXPECT_EQ(json["steps_back"], 1);
  EXPECT_NEAR(json["farthest_back_s"], 3599.9, 1e-6);
  ASSERT_EQ(run("cut " + path("log") + " " + path("kept") + " --channel '.*'").exit_code, 0);
  EXPECT_EQ(read("kept"), read("log")) << "nobody asked to sort it";
  EXPECT_EQ(sorted().rfind("message 20,", 0), 0U);
}

TEST_F(Order, OfTwoLogsIsTheirTimeWhenTheyAreMerged) {
  const auto events = two_channels(40);
  std::vector<logs::OwnedEvent> a;
  std::vector<logs::OwnedEvent> b;
  for (const logs::OwnedEvent& event : events) (event.channel == "A" ? a : b).push_back(event);
  write("a", logs::log_bytes(a));
  write("b", logs::log_bytes(b));
  const CommandResult result = run("merge " + path("b") + " " + path("a") + " " + path("both"));
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(result.output, path("both") + ": 40 events by time; 0 were out of order\n");
  EXPECT_EQ(read("both"), logs::log_bytes(events));
  EXPECT_EQ(run("merge " + path("b") + " " + path("a") + " " + path("both")).exit_code, 2) << "nothing is overwritten";
  EXPECT_NE(run("merge " + path("b") + " " + path("none")).output.find("allowed are two logs or more"),
            std::string::npos);
}

TEST_F(Order, WithASilenceOfMinutesIsTold) {
  auto events = two_channels(4);
  for (std::size_t i = 2; i < events.size(); ++i) events[i].utime += 184'000'000;
  const auto json = info_of(events);
  ASSERT_EQ(json["silences"].size(), 1U);
  EXPECT_NEAR(json["silences"][0]["after_s"], 0.1, 1e-6);
  EXPECT_NEAR(json["silences"][0]["seconds"], 184.1, 1e-6);
  const std::string text = run("info " + path("log")).output;
  EXPECT_NE(text.find("silent: nothing for 3.1 min after 0.1 s"), std::string::npos) << text;
}

// Another system's types: an enumeration, a size in hexadecimal.
constexpr const char* kRover =
    "package rover; enum mode_t { IDLE = 0, BRAKE = 0x10 }\n"
    "struct drive_t { int64_t timestamp; double speed[0x2]; mode_t mode; }\n";

class OthersLog : public LogTool {
 protected:
  OthersLog() {
    write("rover.lcm", kRover);
    // The fingerprint is asked of the tool, which computes it as lcm-gen does.
    const auto types = nlohmann::json::parse(run("types --json --types " + path("rover.lcm")).output);
    const std::uint64_t fingerprint = std::stoull(types["rover.drive_t"].get<std::string>(), nullptr, 16);
    std::string data;
    const auto put = [&data](std::uint64_t number, int size) {
      for (int i = size - 1; i >= 0; --i) data += static_cast<char>(number >> 8 * i & 0xff);
    };
    put(fingerprint, 8);
    put(123, 8);
    put(0x3fe0000000000000, 8);
    put(0x4000000000000000, 8);
    put(16, 4);
    write("log",
          logs::log_bytes({{0, 5, "DRIVE", data}, {1, 6, "TARGET_POSE", logs::payload(logs::target_pose(1, 7, 1))}}));
  }
};

TEST_F(OthersLog, IsKnownByTypesWhereverTheyStandInTheCommand) {
  fs::create_directory(path("types"));
  fs::copy(path("rover.lcm"), path("types"));
  for (const std::string& arguments :
       {path("log") + " --types " + path("rover.lcm") + " --json",
        "--json --types " + path("rover.lcm") + " " + path("log"),
        "--json " + path("log") + " --types " + path("types") + " " + path("rover.lcm")}) {
    const CommandResult result = run("info " + arguments);
    ASSERT_EQ(result.exit_code, 0) << result.output;
    const auto json = nlohmann::json::parse(result.output);
    EXPECT_EQ(json["channels"][0]["type"], "rover.drive_t") << arguments;
    EXPECT_EQ(json["channels"][1]["type"], "TargetPose") << arguments;
  }
}

TEST_F(OthersLog, IsExportedWithTheNamesOfItsValues) {
  EXPECT_EQ(run("export " + path("log") + " " + path("tables") + " --types " + path("rover.lcm")).exit_code, 0);
  EXPECT_EQ(read("tables/DRIVE.csv"), "log_utime,timestamp,speed[0],speed[1],mode\n5,123,0.5,2,BRAKE\n");
  EXPECT_TRUE(fs::exists(path("tables/TARGET_POSE.csv")));
  const CommandResult without = run("export " + path("log") + " " + path("tables2"));
  EXPECT_NE(without.output.find("DRIVE: left out, 1 messages of unknown type 0x"), std::string::npos);
  EXPECT_NE(without.output.find("(--types FILE.lcm... tells it)"), std::string::npos);
}

TEST_F(OthersLog, IsComparedFieldByField) {
  std::string other = read("log");
  other[other.find('\x10')] = '\0';  // the mode
  write("other", other);
  const CommandResult result = run("compare " + path("log") + " " + path("other") + " --types " + path("rover.lcm"));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.output.find("first difference: DRIVE utime 123 mode: recorded 16, replayed 0"), std::string::npos)
      << result.output;
}

TEST_F(OthersLog, SaysWhatIsNoTypeFile) {
  const CommandResult result = run("info " + path("log") + " --types " + path("log"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.output.find(path("log") + ": is no text (a log?); allowed: "), std::string::npos) << result.output;
}

}  // namespace
}  // namespace markservo::log_tool
