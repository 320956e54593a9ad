#include "services/stack-watch/supervisor/process_device.hpp"

// glibc 2.36 declares it for C only.
extern "C" {
#include <sys/pidfd.h>
}
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "common/logging/log.hpp"
#include "services/stack-watch/supervisor/supervisor_reader.hpp"

namespace markservo::stack_watch {

std::string orphans(const std::vector<SupervisedProcess>& processes) {
  std::string text;
  for (const SupervisedProcess& process : processes) {
    if (!runs(process) || kill(process.pid, 0) != 0) continue;
    text += (text.empty() ? "" : ", ") + process.name + " (pid " + std::to_string(process.pid) + ")";
  }
  return text.empty() ? "none" : text;
}

// What it kills is held by a descriptor before the supervisor is asked whether it is still the one: its number cannot
// go to another process in between.
bool kill_if_supervised(const SilentService& silent, const std::string& path) {
  const int descriptor = pidfd_open(silent.pid, 0);
  if (descriptor < 0) {
    if (errno != ESRCH) logging::warn("{} is silent, but cannot be killed: {}", silent.name, std::strerror(errno));
    return false;
  }
  bool killed = false;
  try {
    const auto processes = ask_supervisor(path);
    const bool same = std::any_of(processes.begin(), processes.end(), [&silent](const SupervisedProcess& process) {
      return runs(process) && process.name == silent.name && process.pid == silent.pid;
    });
    killed = same && pidfd_send_signal(descriptor, SIGKILL, nullptr, 0) == 0;
    if (killed) {
      logging::warn("{} (pid {}) said nothing on the bus for {:.1f} s{}: killed", silent.name, silent.pid,
                    1e-6 * static_cast<double>(silent.silent_us), silent.spoke ? "" : " from its start on");
    }
  } catch (const std::runtime_error& error) {
    logging::warn("{} (pid {}) is silent, but is not killed: {}", silent.name, silent.pid, error.what());
  }
  close(descriptor);
  return killed;
}

}  // namespace markservo::stack_watch
