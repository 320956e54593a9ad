#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace markservo::campaign {

// A program that runs beside the trial; ended with the object if it still runs. What it prints goes to a file.
class Child {
 public:
  // In a process group of its own; `environment` is added as "NAME=VALUE". Throws std::runtime_error if it cannot be
  // started.
  Child(const std::vector<std::string>& command, const std::string& log_file,
        const std::vector<std::string>& environment = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // Whether it has ended by itself; then exit_code() says how.
  bool ended();
  int exit_code() const { return exit_code_; }  // 128 + signal for one that was killed
  void signal(int number) const;
  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  bool ended_ = false;
  int exit_code_ = -1;
};

}  // namespace markservo::campaign
