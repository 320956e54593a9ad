#pragma once

// What who commands (operators, scripts, the display, experiments) must know to be obeyed: the movers' time. RESET
// carries the newest STOP_STATE's, once every stop device is heard, START, HOME and DRIVE the newest TASK_STATE's; each
// repeat is stamped anew. STOP and ABORT are obeyed whatever they carry, and wait for nobody.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace markservo::motion {

enum class CommandKind { kStop, kReset, kAbort, kStart, kHome, kDrive };

class CommandSender {
 public:
  // `stop_devices` as in robot.yaml.
  explicit CommandSender(std::vector<std::string> stop_devices) : stop_devices_(std::move(stop_devices)) {}

  // A STOP_STATE of one that is no stop device is passed over.
  void observe_stop_state(const std::string& device, std::int64_t utime) {
    if (std::find(stop_devices_.begin(), stop_devices_.end(), device) == stop_devices_.end()) return;
    heard_.insert(device);
    stop_state_utime_ = utime;
  }
  void observe_task_state(std::int64_t utime) { task_state_utime_ = utime; }

  // The utime (us) to send a command of this kind with now; nothing while it cannot be sent, for it would be refused.
  std::optional<std::int64_t> stamp(CommandKind kind) const {
    switch (kind) {
      case CommandKind::kStop:
        return stop_state_utime_.value_or(0);
      case CommandKind::kAbort:
        return task_state_utime_.value_or(0);
      case CommandKind::kReset:
        return silent_devices().empty() ? stop_state_utime_ : std::nullopt;
      case CommandKind::kStart:
      case CommandKind::kHome:
      case CommandKind::kDrive:
        return task_state_utime_;
    }
    return std::nullopt;
  }

  // The stop devices that have not said how their stop stands.
  std::vector<std::string> silent_devices() const {
    std::vector<std::string> silent;
    for (const std::string& device : stop_devices_) {
      if (heard_.count(device) == 0) silent.push_back(device);
    }
    return silent;
  }

 private:
  std::vector<std::string> stop_devices_;
  std::set<std::string> heard_;
  std::optional<std::int64_t> stop_state_utime_;
  std::optional<std::int64_t> task_state_utime_;
};

}  // namespace markservo::motion
