#include "services/recorder/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace markservo::recorder {
namespace {

constexpr int kCannotRun = 127;  // as a shell says it

[[noreturn]] void complain(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void become(int descriptor, int standard) {
  const int source = descriptor >= 0 ? descriptor : open("/dev/null", O_RDWR | O_CLOEXEC);
  if (source == standard) {
    fcntl(source, F_SETFD, 0);
  } else {
    dup2(source, standard);
  }
}

// In the child, before its program: nothing here allocates.
void set_up(const ChildSetup& setup, pid_t parent) {
  if (setup.own_session) setsid();
  if (setup.ends_with_parent) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(kCannotRun);
  }
  become(setup.in, STDIN_FILENO);
  become(setup.out, STDOUT_FILENO);
  become(setup.error, STDERR_FILENO);
  for (const int descriptor : setup.kept) fcntl(descriptor, F_SETFD, 0);
  if (setup.ignores_broken_pipes) std::signal(SIGPIPE, SIG_IGN);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

}  // namespace

pid_t start_process(const std::string& path, const std::vector<std::string>& arguments, const ChildSetup& setup) {
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child < 0) complain(path.c_str());
  if (child > 0) return child;
  set_up(setup, parent);
  execvp(path.c_str(), words.data());
  _exit(kCannotRun);
}

Pipe::Pipe() {
  if (pipe2(ends_, O_CLOEXEC) != 0) complain("no pipe");
}

Pipe::~Pipe() {
  close(ends_[0]);
  close_write_end();
}

void Pipe::close_write_end() {
  if (ends_[1] >= 0) close(ends_[1]);
  ends_[1] = -1;
}

std::string Pipe::take() const {
  std::array<char, 65536> text;
  pollfd waiting{ends_[0], POLLIN, 0};
  if (::poll(&waiting, 1, 0) <= 0) return {};
  const ssize_t size = read(ends_[0], text.data(), text.size());
  return size <= 0 ? std::string() : std::string(text.data(), static_cast<std::size_t>(size));
}

CommandOutput output_of(const std::vector<std::string>& command) {
  Pipe pipe;
  ChildSetup setup;
  setup.out = pipe.write_end();
  const pid_t child = start_process(command.at(0), command, setup);
  pipe.close_write_end();
  CommandOutput output;
  std::array<char, 65536> text;
  for (ssize_t size = 0; (size = read(pipe.read_end(), text.data(), text.size())) > 0;) {
    output.text.append(text.data(), static_cast<std::size_t>(size));
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status)) output.exit_code = WEXITSTATUS(status);
  return output;
}

void open_standard_descriptors() {
  int descriptor = open("/dev/null", O_RDWR | O_CLOEXEC);
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = dup(descriptor);
  if (descriptor > STDERR_FILENO) close(descriptor);
}

bool is_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace markservo::recorder
