#include "services/recorder/signal_queue.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace markservo::recorder {

SignalQueue::SignalQueue() {
  sigset_t watched;
  sigemptyset(&watched);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) {
    struct sigaction now {};
    sigaction(number, nullptr, &now);
    if (now.sa_handler != SIG_IGN) sigaddset(&watched, number);
  }
  std::signal(SIGCHLD, SIG_DFL);  // ignored, nobody would learn how a child ended
  sigaddset(&watched, SIGCHLD);
  sigprocmask(SIG_BLOCK, &watched, nullptr);
  descriptor_ = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "signals cannot be watched");
}

SignalQueue::~SignalQueue() {
  close(descriptor_);
}

bool SignalQueue::told() {
  take();
  return told_;
}

void SignalQueue::wait(std::int64_t timeout_us, int descriptor) {
  constexpr std::int64_t kMillisecond_us = 1000;
  pollfd waiting[2] = {{descriptor_, POLLIN, 0}, {descriptor, POLLIN, 0}};  // the kernel passes over a negative one
  poll(waiting, 2, static_cast<int>((timeout_us + kMillisecond_us - 1) / kMillisecond_us));
  take();
}

void SignalQueue::take() {
  signalfd_siginfo signal{};
  while (read(descriptor_, &signal, sizeof signal) == sizeof signal) {
    if (signal.ssi_signo != SIGCHLD) told_ = true;
  }
}

}  // namespace markservo::recorder
