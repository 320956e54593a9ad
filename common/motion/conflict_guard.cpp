#include "common/motion/conflict_guard.hpp"

#include <cstdlib>

namespace markservo::motion {
namespace {

constexpr std::int64_t kRepeat_us = 200'000;  // LCM may lose one

}  // namespace

void ConflictGuard::raise(const std::string& why) {
  if (state_ != State::kQuiet) return;
  why_ = why;
  ask();
}

void ConflictGuard::ask() {
  state_ = State::kStopping;
  ++id_;
  sent_ = false;
}

bool ConflictGuard::hear_stop_state(bool latched, bool alone) {
  if (state_ == State::kStopping && latched && sent_) state_ = State::kStopped;
  if (state_ != State::kStopped || latched) return false;
  if (!alone) {
    ask();
    return false;
  }
  state_ = State::kQuiet;
  why_.clear();
  return true;
}

std::optional<StopWish> ConflictGuard::due(std::int64_t now) {
  if (state_ != State::kStopping) return std::nullopt;
  if (sent_ && std::abs(now - sent_at_) < kRepeat_us) return std::nullopt;
  sent_ = true;
  sent_at_ = now;
  return StopWish{id_, why_};
}

}  // namespace markservo::motion
