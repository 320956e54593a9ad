#include "services/recorder/logger/kept_logger.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "services/recorder/logger/logger_names.hpp"
#include "services/recorder/proc_reader.hpp"

namespace markservo::recorder {

KeptLogger::KeptLogger(const std::vector<std::string>& arguments, int lock) {
  std::vector<std::string> command = {kKeepLogger, kKeepLogger, std::to_string(getpid()),
                                      std::to_string(STDERR_FILENO)};
  command.insert(command.end(), arguments.begin(), arguments.end());
  ChildSetup setup;
  setup.error = words_.write_end();
  setup.kept = {lock};
  setup.own_session = true;
  setup.ends_with_parent = true;
  // This program, also when its file has been replaced since it began.
  keeper_ = start_process("/proc/self/exe", command, setup);
  words_.close_write_end();
}

KeptLogger::~KeptLogger() {
  if (!end_) end();
}

bool KeptLogger::is_alive() {
  int status = 0;
  if (!end_ && waitpid(keeper_, &status, WNOHANG) == keeper_) note_end(status);
  return !end_;
}

LoggerEnd KeptLogger::end() {
  if (is_alive()) {
    int status = 0;
    kill(keeper_, SIGTERM);
    waitpid(keeper_, &status, 0);
    note_end(status);
  }
  return *end_;
}

std::optional<int> KeptLogger::threads() {
  if (!logger_) logger_ = child_named(keeper_, kLcmLogger);
  if (!logger_) return std::nullopt;
  return static_cast<int>(threads_of(*logger_).size());
}

bool KeptLogger::logger_lives() const {
  return logger_ && program_of(*logger_) == kLcmLogger;
}

void KeptLogger::note_end(int status) {
  if (WIFSIGNALED(status)) {
    end_ = LoggerEnd{LoggerEnd::Who::kKeeper, true, WTERMSIG(status)};
  } else {
    end_ = told_by_keeper(WEXITSTATUS(status));
  }
}

}  // namespace markservo::recorder
