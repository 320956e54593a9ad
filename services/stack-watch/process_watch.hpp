#pragma once

// How each process of a stack is, in one word, and why: of what its supervisor says, what was heard of it on the bus,
// and what the watch did to it. No bus, no clock, no process: the caller tells.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "services/stack-watch/incidents.hpp"
#include "services/stack-watch/supervisor/supervisor_words.hpp"

namespace markservo::stack_watch {

// Numbered as ProcessStatus numbers them.
enum class ProcessState { kStopped, kStarting, kRunning, kSilent, kWaiting, kEnded, kFailed };

struct ProcessWord {
  std::string name;
  ProcessState state = ProcessState::kStopped;
  int pid = 0;                   // 0: none
  std::int64_t start_utime = 0;  // us, wall clock; 0: none
  int restarts = 0;              // since the watch began
  std::string why;               // empty when all is well
};

// What the supervisor does not know of a process.
struct ProcessFindings {
  std::int64_t silent_us = -1;  // since it was heard; -1: it has not spoken
  std::int64_t limit_us = 0;    // of silence, after which it is killed
};

// All that is known at a moment.
struct StackFindings {
  const std::vector<SupervisedProcess>& processes;  // as they were told last
  std::string supervisor_trouble;                   // why they may not be so any more; empty: they are
  std::map<std::string, ProcessFindings> heard;     // by name
  const Kills& kills;
};

class ProcessWatch {
 public:
  // Of each process at `now_us`, wall clock. The watch itself is none of them.
  std::vector<ProcessWord> words(const StackFindings& found, std::int64_t now_us);

 private:
  struct Memory {
    int pid = 0;  // the last one, 0: there was none yet
    int restarts = 0;
    std::int64_t restarted_us = 0;  // wall clock; 0: never
    std::string why;                // it was restarted
  };

  void follow(const SupervisedProcess& process, const Kills& kills, std::int64_t now_us);

  std::map<std::string, Memory> memory_;
};

}  // namespace markservo::stack_watch
