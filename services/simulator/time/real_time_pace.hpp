#pragma once

// Simulated time beside a steady clock's.

#include <algorithm>
#include <cstdint>

namespace markservo::simulator {

// Never early: what is told is never from the future, not even after a reset, when the world's time leaps by a second.
// On too slow a machine time goes on from where it is. All times in us.
class RealTimePace {
 public:
  // The world is at `utime` while the steady clock says `now`.
  RealTimePace(std::int64_t utime, std::int64_t now) : ahead_(now - utime) {}

  // How long the world at `utime` still has to wait; 0 when it need not.
  std::int64_t wait(std::int64_t utime, std::int64_t now) {
    constexpr std::int64_t kSlipLimit_us = 100'000;  // how far simulated time may fall behind before it slips
    if (utime + ahead_ < now - kSlipLimit_us) ahead_ = now - utime;
    return std::max<std::int64_t>(0, utime + ahead_ - now);
  }

 private:
  std::int64_t ahead_;  // of the steady clock before the world's
};

}  // namespace markservo::simulator
