#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace markservo::experiments {

// A service started by an experiment; ended (SIGTERM, then SIGKILL) with the object, and with the experiment itself.
class ChildProcess {
 public:
  // `command[0]` is the executable's path. What it prints goes to `log_file`.
  // Throws std::runtime_error if it cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::string& log_file);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Waits for its end by itself; the exit code, or 128 + signal.
  int wait();
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
};

}  // namespace markservo::experiments
