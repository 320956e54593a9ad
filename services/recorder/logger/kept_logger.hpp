#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "services/recorder/logger/logger_end.hpp"
#include "services/recorder/process.hpp"

namespace markservo::recorder {

// lcm-logger as a child of keep-logger, which is a child of this process: it writes what it has received although this
// process is killed. Told to end, where it still runs, with the object.
class KeptLogger {
 public:
  // `arguments` are lcm-logger's; `lock`, a descriptor, is held for as long as either of the two lives. Throws
  // std::system_error.
  KeptLogger(const std::vector<std::string>& arguments, int lock);
  ~KeptLogger();
  KeptLogger(const KeptLogger&) = delete;
  KeptLogger& operator=(const KeptLogger&) = delete;

  bool is_alive();
  // Where it lives, lets it write what waits, ends it, and waits for that. How it ended.
  LoggerEnd end();

  // lcm-logger's threads; nothing until it runs.
  std::optional<int> threads();
  // Whether lcm-logger itself lives, although keep-logger may not.
  bool logger_lives() const;
  // What it has said since this was asked last.
  std::string take_words() const { return words_.take(); }

 private:
  void note_end(int status);

  Pipe words_;
  pid_t keeper_ = -1;
  std::optional<pid_t> logger_;
  std::optional<LoggerEnd> end_;
};

}  // namespace markservo::recorder
