#pragma once

#include <optional>
#include <string>

namespace markservo::base_navigator {

// Whether the base may move at all: its stop is released, and no two claim to be what it moves by.
class MotionEnable {
 public:
  // The base's own STOP_STATE.
  void observe_stop(bool latched, const std::string& reason);
  // `why`: which two contradict each other; empty when none do.
  void observe_conflict(const std::string& why) { conflict_ = why; }

  // False also before the first STOP_STATE.
  bool latched() const { return latched_.value_or(false); }
  // Why the base must stand; empty when it may move.
  std::string why_stopped() const;

 private:
  std::optional<bool> latched_;
  std::string stop_reason_;
  std::string conflict_;
};

}  // namespace markservo::base_navigator
