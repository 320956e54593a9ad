#include "services/simulator/node/answer_wait_node.hpp"

#include <algorithm>
#include <chrono>

namespace markservo::simulator {
namespace {

using std::chrono::duration;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

// What nobody could answer yet is sent again, ever less often: an answer may take long on a busy machine.
constexpr milliseconds kFirstRepeat{500};
constexpr milliseconds kLongestRepeat{2000};
constexpr milliseconds kPatience{1000};  // before the state says what is waited for

}  // namespace

AnswerWait::Outcome AnswerWait::run(bus::Bus& bus, const LockstepBarrier& barrier, double timeout_s) {
  if (barrier.complete()) return Outcome::kAnswered;
  const auto begin = steady_clock::now();
  auto sent = begin;
  milliseconds pause = kFirstRepeat;
  while (!barrier.complete()) {
    if (!bus.poll(milliseconds(20))) return Outcome::kEnded;
    if (interrupted_()) return Outcome::kInterrupted;
    const auto now = steady_clock::now();
    if (now - begin > kPatience) bus.set_state("waiting", "for " + barrier.missing());
    if (answered_once_) {
      if (now - begin >= duration<double>(timeout_s)) return Outcome::kTimedOut;
    } else if (now - sent >= pause) {
      repeat_();
      sent = now;
      pause = std::min(2 * pause, kLongestRepeat);
    }
  }
  answered_once_ = true;
  bus.set_state("lockstep");
  return Outcome::kAnswered;
}

}  // namespace markservo::simulator
