#pragma once

#include <string>

namespace markservo::recorder {

// How lcm-logger, or keep-logger which runs it, ended.
struct LoggerEnd {
  enum class Who { kLogger, kKeeper };
  Who who = Who::kLogger;
  bool by_signal = false;
  int number = 0;  // exit code or signal

  bool is_well() const { return !by_signal && number == 0; }
  // It ended by itself and says so: a disk that is full, a file that cannot be written. The next one would fare alike.
  bool is_own_word() const { return !by_signal && number > 0 && number < 128; }
  // As a shell gives it: 128 and the signal.
  int exit_code() const { return by_signal ? 128 + number : number; }
};

// The two ends that keep-logger's own exit code tells: lcm-logger's exit code, or 192 and the signal that ended it.
int keeper_exit_code(const LoggerEnd& end);
LoggerEnd told_by_keeper(int exit_code);

// In words: "lcm-logger was killed by signal 9 (SIGKILL)".
std::string text_of(const LoggerEnd& end);

}  // namespace markservo::recorder
