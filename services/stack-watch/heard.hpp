#pragma once

// What was heard on the bus in the last 5 to 10 s, and since when each service is as it is. No bus, no clock: the
// caller tells what came and when.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "common/census/census.hpp"

namespace markservo::stack_watch {

// Wall clock and a clock that nobody sets, us.
struct Instant {
  std::int64_t wall_us = 0;
  std::int64_t steady_us = 0;
};

class RecentCensus {
 public:
  // Long enough for rates of 1 Hz, short enough to follow the present.
  static constexpr std::int64_t kSpan_us = 5'000'000;

  explicit RecentCensus(Instant now) : older_(now.wall_us), newer_(now.wall_us), turned_us_(now.steady_us) {}

  // What the stack's supervisor runs: others cannot crowd it out.
  void observe(const census::KnownProcesses& known);
  void observe(const census::Heard& message);
  void observe(const census::ServiceWord& word, Instant now);
  // To be called once a second at least.
  void step(Instant now);

  census::Report report(Instant now) const { return older_.report(now.wall_us); }
  // When the process began to be in the state that it is in, us of the wall clock; nothing where it was not heard.
  std::optional<std::int64_t> state_since_us(const census::ServiceWord& word) const;

 private:
  using Process = std::tuple<std::string, std::string, int>;  // name, host and pid
  struct State {
    std::string state;
    std::int64_t since_us = 0;  // wall clock
    std::int64_t heard_us = 0;  // steady
  };
  // More processes no bus has: a hostile writer must not take all memory.
  static constexpr std::size_t kMaxProcesses = 1024;
  static constexpr std::int64_t kForgotten_us = 60'000'000;

  census::Census older_;
  census::Census newer_;
  census::KnownProcesses known_;
  std::int64_t turned_us_;
  std::map<Process, State> states_;
};

}  // namespace markservo::stack_watch
