#include "services/stack-watch/process_watch.hpp"

#include <gtest/gtest.h>

namespace markservo::stack_watch {
namespace {

constexpr std::int64_t kSecond = 1'000'000;
constexpr std::int64_t kNow = 1'800'000'000 * kSecond;

SupervisedProcess process(const std::string& state, int pid = 7) {
  SupervisedProcess result;
  result.name = "arm";
  result.state = state;
  result.pid = pid;
  return result;
}

class WatchedProcess : public ::testing::Test {
 protected:
  ProcessWord word(const SupervisedProcess& process, std::int64_t now_us = kNow) {
    return watch_.words({{process}, trouble_, findings_, kills_}, now_us).at(0);
  }

  ProcessWatch watch_;
  std::map<std::string, ProcessFindings> findings_;
  Kills kills_;
  std::string trouble_;
};

TEST_F(WatchedProcess, RunsAndIsWell) {
  SupervisedProcess running = process("RUNNING");
  running.start_utime = kNow - 5 * kSecond;
  const ProcessWord told = word(running);
  EXPECT_EQ(told.state, ProcessState::kRunning);
  EXPECT_EQ(told.pid, 7);
  EXPECT_EQ(told.start_utime, kNow - 5 * kSecond);
  EXPECT_EQ(told.restarts, 0);
  EXPECT_EQ(told.why, "");
}

TEST_F(WatchedProcess, ThatSaysNothingAnyMoreIsCalledSilentBeforeItIsKilled) {
  findings_["arm"] = {3 * kSecond, 5 * kSecond};
  EXPECT_EQ(word(process("RUNNING")).state, ProcessState::kRunning);
  findings_["arm"] = {4 * kSecond, 5 * kSecond};
  EXPECT_EQ(word(process("RUNNING")).state, ProcessState::kSilent);
  EXPECT_EQ(word(process("RUNNING")).why, "it has said nothing for 4 s: killed after 5 s");
  findings_["arm"] = {-1, 5 * kSecond};
  EXPECT_EQ(word(process("RUNNING")).state, ProcessState::kRunning) << "it has not spoken yet";
}

TEST_F(WatchedProcess, ThatWasKilledForItsSilenceSaysSoForAMinute) {
  word(process("RUNNING", 7));
  kills_.add({"arm", 7, 5.2, true, kNow});
  SupervisedProcess ended = process("EXITED", 0);
  ended.exit_code = -1;
  EXPECT_EQ(word(ended).state, ProcessState::kWaiting);
  EXPECT_EQ(word(ended).why, "it was killed, silent for 5 s");
  const ProcessWord told = word(process("RUNNING", 8), kNow + kSecond);
  EXPECT_EQ(told.restarts, 1);
  EXPECT_EQ(told.why, "started again: it was killed, silent for 5 s");
  EXPECT_EQ(word(process("RUNNING", 8), kNow + 62 * kSecond).why, "");
  EXPECT_EQ(word(process("RUNNING", 8), kNow + 62 * kSecond).restarts, 1);
}

TEST_F(WatchedProcess, ThatCrashesAgainAndAgainTellsHowOftenAndWhenItBeginsAgain) {
  SupervisedProcess crashed = process("RUNNING");
  crashed.crashes = 3;
  crashed.next_start_s = 2.2;
  EXPECT_EQ(word(crashed).state, ProcessState::kWaiting);
  EXPECT_EQ(word(crashed).why, "it crashed 3 times in a row: started again in 2 s");
  crashed.next_start_s = -0.1;
  EXPECT_EQ(word(crashed).state, ProcessState::kRunning);
}

TEST_F(WatchedProcess, ThatEndedForGoodTellsByWhichCodeAndOthersWait) {
  SupervisedProcess ended = process("EXITED", 0);
  ended.exit_code = 2;
  EXPECT_EQ(word(ended).state, ProcessState::kEnded);
  EXPECT_EQ(word(ended).why, "its configuration is bad (exit code 2); its log says what");
  ended.exit_code = -1;
  EXPECT_EQ(word(ended).state, ProcessState::kWaiting);
  EXPECT_EQ(word(ended).why, "it was ended by a signal");
}

TEST_F(WatchedProcess, ThatCannotBeStartedTellsWhy) {
  SupervisedProcess fatal = process("FATAL", 0);
  fatal.spawn_error = "can't find command";
  EXPECT_EQ(word(fatal).state, ProcessState::kFailed);
  EXPECT_EQ(word(fatal).why, "can't find command");
}

TEST_F(WatchedProcess, WhoseSupervisorIsDeadIsAsItWasToldLastAndSaysSo) {
  trouble_ = "its supervisor is dead";
  EXPECT_EQ(word(process("RUNNING")).state, ProcessState::kRunning);
  EXPECT_EQ(word(process("RUNNING")).why, "its supervisor is dead");
}

TEST_F(WatchedProcess, IsNotTheWatchItself) {
  SupervisedProcess self = process("RUNNING");
  self.name = "stack-watch";
  EXPECT_TRUE(watch_.words({{self}, "", {}, kills_}, kNow).empty());
}

}  // namespace
}  // namespace markservo::stack_watch
