// What runs lcm-logger, with a stand-in for it, and what completes a recording that was killed.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "services/recorder/manifest/manifest_file.hpp"
#include "tests/unit/command.hpp"
#include "tests/unit/recorder/scratch_folder.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;
using test::CommandResult;

constexpr const char* kRecorder = MARKSERVO_BIN_DIR "/recorder";

std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

class Command : public ::testing::Test {
 protected:
  // keep-logger with an lcm-logger that runs `code`, a shell's; `around` may use $keeper, which runs beside it.
  CommandResult keep(const std::string& code, const std::string& around = "") const {
    scratch_.write("bin/lcm-logger", "#!/bin/bash\n" + code + "\n");
    fs::permissions(scratch_.path("bin/lcm-logger"), fs::perms::owner_all);
    scratch_.write("run", "PATH=" + quoted(scratch_.path("bin")) + ":$PATH\n" + kRecorder +
                              " keep-logger $$ 1 a 'b c' &\nkeeper=$!\n" + around + "\nwait $keeper\nexit $?\n");
    return test::run_command("bash " + quoted(scratch_.path("run")));
  }

  ScratchFolder scratch_{"recorder_command_test"};
};

using KeepLogger = Command;

TEST_F(KeepLogger, PassesOnWhatIsWorthKeepingAndTheExitCode) {
  const CommandResult result = keep("echo 'Summary: fine'; echo \"$# $2\"; echo 'Disk full!' >&2; exit 7");
  EXPECT_EQ(result.output, "2 b c\nDisk full!\n");
  EXPECT_EQ(result.exit_code, 7);
}

TEST_F(KeepLogger, TellsTheSignalThatEndedTheLogger) {
  EXPECT_EQ(keep("kill -9 $$").exit_code, 192 + 9);
}

TEST_F(KeepLogger, EndsTheLoggerWhenItIsToldTo) {
  const CommandResult result =
      keep("trap 'echo told; exit 3' TERM; echo begun; while true; do sleep 0.02; done", "sleep 0.5; kill $keeper");
  EXPECT_EQ(result.output, "begun\ntold\n");
  EXPECT_EQ(result.exit_code, 3);
}

TEST_F(KeepLogger, EndsTheLoggerWhenItIsKilled) {
  const CommandResult result = keep(
      "told=" + quoted(scratch_.path("told")) + "\ntrap 'echo > \"$told\"; exit' TERM; while true; do sleep 0.02; done",
      "sleep 0.5; kill -9 $keeper; for i in {1..100}; do [[ -e " + quoted(scratch_.path("told")) +
          " ]] && break; sleep 0.1; done");
  EXPECT_TRUE(scratch_.has("told"));
  EXPECT_EQ(result.exit_code, 128 + 9);
}

TEST_F(KeepLogger, SaysThatThereIsNoLogger) {
  EXPECT_EQ(test::run_command("env PATH=/nowhere " + std::string(kRecorder) + " keep-logger 1 1 x").exit_code, 127);
  EXPECT_EQ(test::run_command(std::string(kRecorder) + " keep-logger").exit_code, 2);
}

class Finish : public Command {
 protected:
  Finish() {
    scratch_.write("config/robot.yaml", "arm: {}\n");
    scratch_.write(
        "killed/manifest.json",
        R"({"format_version": 1, "start": {"utc": "", "utime": 1700000000000000}, "end": null, "gaps": []})");
    scratch_.write("killed/manifest.json.new", "{");
    scratch_.write("killed/.reserve", "0");
  }
  CommandResult record(const std::string& options) const {
    scratch_.write("run",
                   "cd " + quoted(scratch_.path()) + "\nexec -a 'markservo record' " + kRecorder + " " + options);
    return test::run_command("bash " + quoted(scratch_.path("run")));
  }
};

TEST_F(Finish, CompletesTheManifestOfARecordingThatWasKilled) {
  const CommandResult result = record("--finish killed");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  EXPECT_EQ(result.output.rfind("completed killed: ", 0), 0U) << result.output;
  const Json manifest = read_manifest(scratch_.path("killed"));
  EXPECT_EQ(manifest["ended_by"], "killed");
  EXPECT_GT(manifest["end"]["utime"], manifest["start"]["utime"]);
  EXPECT_EQ(manifest["events"], 0);
  EXPECT_FALSE(scratch_.has("killed/manifest.json.new"));
  EXPECT_FALSE(scratch_.has("killed/.reserve"));
}

TEST_F(Finish, ChangesNothingTheSecondTime) {
  record("--finish killed");
  const std::string manifest = scratch_.read("killed/manifest.json");
  const CommandResult result = record("--finish killed");
  EXPECT_EQ(result.output.rfind("complete already: killed: ", 0), 0U) << result.output;
  EXPECT_EQ(scratch_.read("killed/manifest.json"), manifest);
}

TEST_F(Finish, RefusesWhatIsNoRecording) {
  const CommandResult result = record("--finish config");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.output, "record: --finish " + scratch_.path("config") +
                               ": has no manifest.json of a recording; allowed: a folder that markservo record made\n");
}

TEST_F(Finish, TakesNoEmptyOrTornManifestForACompleteOne) {
  for (const std::string text : {"", "\n", "{", "{}", "null", R"({"format_version": 1, "end": true, "start": {}})"}) {
    scratch_.write("config/manifest.json", text);
    const CommandResult result = record("--finish config");
    EXPECT_EQ(result.exit_code, 2) << text;
    EXPECT_EQ(result.output, "record: --finish " + scratch_.path("config") +
                                 ": its manifest.json is empty or torn; allowed: a folder that markservo record made. "
                                 "Its log, if it has one, can be read without: markservo log info\n")
        << text;
    EXPECT_EQ(scratch_.read("config/manifest.json"), text);
  }
}

TEST_F(Finish, NamesTheCommandThatWasTyped) {
  EXPECT_EQ(record("--for soon").output, "record: --for soon; allowed: 1 to 99999999; see markservo record --help\n");
}

TEST_F(Finish, MakesAFolderForWhoRecordsIntoItLater) {
  const CommandResult result = record("--logs-dir logs --new-folder");
  EXPECT_EQ(result.exit_code, 0) << result.output;
  std::string path = result.output;
  path.erase(std::remove(path.begin(), path.end(), '\n'), path.end());
  EXPECT_TRUE(fs::is_directory(path)) << path;
  EXPECT_TRUE(fs::equivalent(path, scratch_.path("logs/latest")));
}

}  // namespace
}  // namespace markservo::recorder
