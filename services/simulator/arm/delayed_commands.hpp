#pragma once

// Commands on their way to the servos: each takes effect when its time has come.

#include <cstdint>
#include <deque>
#include <optional>

#include "services/simulator/arm/arm_command.hpp"

namespace markservo::simulator {

class DelayedCommands {
 public:
  // `when`: a frame's number in lockstep, simulated time (us) otherwise.
  void add(std::int64_t when, const ArmCommand& command) { waiting_.push_back({when, command}); }

  // The newest command due at `now`, if any; it and those before it are gone then.
  std::optional<ArmCommand> take(std::int64_t now) {
    std::optional<ArmCommand> due;
    while (!waiting_.empty() && waiting_.front().when <= now) {
      due = waiting_.front().command;
      waiting_.pop_front();
    }
    return due;
  }

  void forget() { waiting_.clear(); }

 private:
  struct Entry {
    std::int64_t when;
    ArmCommand command;
  };
  std::deque<Entry> waiting_;
};

}  // namespace markservo::simulator
