#include "tests/system/fault_campaign/child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

namespace markservo::campaign {

Child::Child(const std::vector<std::string>& command, const std::string& log_file,
             const std::vector<std::string>& environment) {
  std::vector<char*> argv;
  for (const auto& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(command.at(0) + ": cannot be started");
  if (pid_ > 0) return;
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  setpgid(0, 0);
  for (const auto& setting : environment) putenv(const_cast<char*>(setting.c_str()));
  const int log = open(log_file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  execvp(argv[0], argv.data());
  _exit(127);
}

Child::~Child() {
  if (ended()) return;
  signal(SIGTERM);
  for (int tries = 0; tries < 150 && !ended(); ++tries) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (ended_) return;
  signal(SIGKILL);
  waitpid(pid_, nullptr, 0);
}

bool Child::ended() {
  int status = 0;
  if (!ended_ && waitpid(pid_, &status, WNOHANG) == pid_) {
    ended_ = true;
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return ended_;
}

void Child::signal(int number) const {
  if (!ended_) kill(-pid_, number);
}

}  // namespace markservo::campaign
