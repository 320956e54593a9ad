#pragma once

// What supervisord says of the processes it keeps: its XML-RPC answers, read as far as they are needed here.

#include <map>
#include <string>
#include <vector>

namespace markservo::stack_watch {

// The request that asks for all processes, as the body of an HTTP POST to /RPC2.
inline constexpr const char* kAskForProcesses =
    "<?xml version=\"1.0\"?><methodCall><methodName>supervisor.getAllProcessInfo</methodName></methodCall>";

struct SupervisedProcess {
  std::string name;
  std::string state;  // supervisor's word: RUNNING, STARTING, STOPPING, STOPPED, EXITED, BACKOFF, FATAL
  int pid = 0;        // 0: none
};

// Whether it is a service of the stack that is up, or coming up; the watch itself is none.
bool runs(const SupervisedProcess& process);

// The processes in the answer to kAskForProcesses; throws std::invalid_argument for what is no such answer.
std::vector<SupervisedProcess> processes_in(const std::string& answer);

}  // namespace markservo::stack_watch
