#pragma once

// What supervisord says of the processes it keeps: its XML-RPC answers, read as far as they are needed here.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace markservo::stack_watch {

// The request that asks for all processes, as the body of an HTTP POST to /RPC2.
inline constexpr const char* kAskForProcesses =
    "<?xml version=\"1.0\"?><methodCall><methodName>supervisor.getAllProcessInfo</methodName></methodCall>";

struct SupervisedProcess {
  std::string name;
  std::string state;             // supervisor's word: RUNNING, STARTING, STOPPING, STOPPED, EXITED, BACKOFF, FATAL
  int pid = 0;                   // 0: none
  std::int64_t start_utime = 0;  // us, wall clock, to the second: of the newest process; 0: there was none
  int exit_code = 0;             // of the last one; -1: by a signal
  std::string spawn_error;       // why it cannot be started
  // By what starts it (scripts/lib/pause-before-start.sh), not by the supervisor, for whom the pause is a process.
  int crashes = 0;            // in a row, each soon after its start
  double next_start_s = 0.0;  // until it is started again, s; 0 or less: it is not waited for
};

// Whether it is a service of the stack that is up, or coming up; the watch itself is none.
bool runs(const SupervisedProcess& process);

// The processes in the answer to kAskForProcesses; throws std::invalid_argument for what is no such answer.
std::vector<SupervisedProcess> processes_in(const std::string& answer);

}  // namespace markservo::stack_watch
