#include "services/stack-watch/process_watch.hpp"

#include <cmath>
#include <set>

#include "common/census/census.hpp"

namespace markservo::stack_watch {
namespace {

// Of its limit: a person shall hear of it before it is killed, and one late word of a busy machine is no silence.
constexpr double kSilentShare = 0.7;

// As in config/supervisord.conf: one that leaves so is not started again.
const std::set<int>& final_codes() {
  static const std::set<int> codes{0, 2, 3};
  return codes;
}

std::string seconds_text(double seconds) {
  return std::to_string(std::lround(seconds)) + " s";
}

std::string left_with(int code) {
  switch (code) {
    case 0:
      return "it ended by itself (exit code 0)";
    case 2:
      return "its configuration is bad (exit code 2); its log says what";
    case 3:
      return "there is no such bus (exit code 3)";
    default:
      return code < 0 ? "it was ended by a signal" : "it crashed (exit code " + std::to_string(code) + ")";
  }
}

std::string crash_text(const SupervisedProcess& process) {
  if (process.crashes < 2) return "it crashed";
  return "it crashed " + std::to_string(process.crashes) + " times in a row";
}

std::string killed_text(double silent_s) {
  return "it was killed, silent for " + seconds_text(silent_s);
}

struct StateAndWhy {
  ProcessState state;
  std::string why;
};

StateAndWhy told_by_supervisor(const SupervisedProcess& process) {
  if (process.next_start_s > 0.0) {
    return {ProcessState::kWaiting, crash_text(process) + ": started again in " + seconds_text(process.next_start_s)};
  }
  if (process.state == "RUNNING") return {ProcessState::kRunning, {}};
  if (process.state == "STARTING") return {ProcessState::kStarting, {}};
  if (process.state == "STOPPED" || process.state == "STOPPING") return {ProcessState::kStopped, {}};
  if (process.state == "BACKOFF") return {ProcessState::kWaiting, "cannot be started: " + process.spawn_error};
  if (process.state == "EXITED") {
    const bool is_final = final_codes().count(process.exit_code) > 0;
    return {is_final ? ProcessState::kEnded : ProcessState::kWaiting, left_with(process.exit_code)};
  }
  return {ProcessState::kFailed,
          process.spawn_error.empty() ? "the supervisor calls it " + process.state : process.spawn_error};
}

bool is_silent(const ProcessFindings& findings) {
  return findings.silent_us >= 0 &&
         static_cast<double>(findings.silent_us) > kSilentShare * static_cast<double>(findings.limit_us);
}

}  // namespace

std::vector<ProcessWord> ProcessWatch::words(const StackFindings& found, std::int64_t now_us) {
  std::vector<ProcessWord> words;
  for (const SupervisedProcess& process : found.processes) {
    if (process.name == census::kStackWatch) continue;
    follow(process, found.kills, now_us);
    const Memory& memory = memory_[process.name];
    auto [state, why] = told_by_supervisor(process);
    const auto heard = found.heard.find(process.name);
    if (state == ProcessState::kRunning && heard != found.heard.end() && is_silent(heard->second)) {
      state = ProcessState::kSilent;
      why = "it has said nothing for " + seconds_text(1e-6 * static_cast<double>(heard->second.silent_us)) +
            ": killed after " + seconds_text(1e-6 * static_cast<double>(heard->second.limit_us));
    }
    if (state == ProcessState::kWaiting && process.pid == 0) {
      if (const auto killed = found.kills.silent_s(process.name, memory.pid)) why = killed_text(*killed);
    }
    if (why.empty() && memory.restarts > 0 && now_us - memory.restarted_us < kTold_us) why = memory.why;
    if (!found.supervisor_trouble.empty()) why = found.supervisor_trouble;
    words.push_back({process.name, state, process.pid, process.start_utime, memory.restarts, why});
  }
  return words;
}

void ProcessWatch::follow(const SupervisedProcess& process, const Kills& kills, std::int64_t now_us) {
  if (process.pid == 0) return;
  Memory& memory = memory_[process.name];
  if (memory.pid == process.pid) return;
  if (memory.pid != 0) {
    ++memory.restarts;
    memory.restarted_us = now_us;
    const auto killed = kills.silent_s(process.name, memory.pid);
    memory.why = killed                ? "started again: " + killed_text(*killed)
                 : process.crashes > 0 ? "started again: " + crash_text(process)
                                       : "started again";
  }
  memory.pid = process.pid;
}

}  // namespace markservo::stack_watch
