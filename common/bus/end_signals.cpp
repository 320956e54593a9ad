#include "common/bus/end_signals.hpp"

#include <csignal>

namespace markservo::bus {
namespace {

volatile std::sig_atomic_t signalled = 0;

void on_signal(int) {
  signalled = 1;
}

}  // namespace

void note_end_signals(bool hangup) {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (hangup) std::signal(SIGHUP, on_signal);
}

bool told_to_end() {
  return signalled != 0;
}

}  // namespace markservo::bus
