#pragma once

#include <cstdint>

namespace markservo::simulator {

// Counts a wheel's turning in ticks, and wraps around.
class WheelEncoder {
 public:
  // `tick`: m of way, above 0. `first_count`: of its counter at the start.
  WheelEncoder(double tick, int counter_bits, std::int64_t first_count)
      : tick_(tick), counter_bits_(counter_bits), first_count_(first_count) {}

  void turn(double way) { way_ += way; }  // m, forward

  // Raw, from 0 to 2^counter_bits - 1 (all 32 bits of an int32 at counter_bits 32).
  std::int32_t counter() const;
  double distance() const { return static_cast<double>(turned()) * tick_; }  // m since the start, from the ticks

 private:
  std::int64_t turned() const;  // whole ticks since the start

  double tick_;
  int counter_bits_;
  std::int64_t first_count_;
  double way_ = 0.0;  // m
};

}  // namespace markservo::simulator
