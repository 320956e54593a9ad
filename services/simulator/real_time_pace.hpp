#pragma once

// Simulated time beside this host's steady clock.

#include <chrono>
#include <cstdint>

namespace markservo::simulator {

// Never early: what is told is never from the future, not even after a reset, when the world's time leaps by a second.
// On too slow a machine time goes on from where it is.
class RealTimePace {
 public:
  using Clock = std::chrono::steady_clock;

  // `utime`: us, of the world now.
  RealTimePace(std::int64_t utime, Clock::time_point now) : start_(now), start_utime_(utime) {}

  // How long the world at `utime` still has to wait, rounded up; 0 when it need not.
  std::chrono::milliseconds wait(std::int64_t utime, Clock::time_point now) {
    constexpr std::chrono::milliseconds kSlipLimit{100};  // how far simulated time may fall behind before it slips
    if (due(utime) < now - kSlipLimit) {
      start_ = now;
      start_utime_ = utime;
    }
    const auto early = std::chrono::ceil<std::chrono::milliseconds>(due(utime) - now);
    return early > early.zero() ? early : early.zero();
  }

 private:
  Clock::time_point due(std::int64_t utime) const { return start_ + std::chrono::microseconds(utime - start_utime_); }

  Clock::time_point start_;
  std::int64_t start_utime_;
};

}  // namespace markservo::simulator
