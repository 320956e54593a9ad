#pragma once

// Whether the arm may be moved at all: by the word of its STOP_STATE, and unless two claim to be one.

#include <optional>
#include <string>

namespace markservo::visual_servo {

class MotionEnable {
 public:
  // The arm's STOP_STATE; `reason` for people.
  void observe_stop(bool latched, const std::string& reason);
  // Why nothing may move though no stop is latched; empty when nothing speaks against it.
  void observe_conflict(const std::string& why) { conflict_ = why; }

  // Before the first STOP_STATE the arm is neither.
  bool latched() const { return latched_.value_or(false); }
  bool released() const { return !latched_.value_or(true); }

  const std::string& conflict() const { return conflict_; }
  // Empty when released.
  std::string why_stopped() const;

 private:
  std::optional<bool> latched_;
  std::string reason_;
  std::string conflict_;
};

}  // namespace markservo::visual_servo
