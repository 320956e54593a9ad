#pragma once

// What a reader knows of one thing that moves and of all that leads to its motion: whose word counts, how its stop
// stands, what time it is, and whether two claim to be one. Then nothing may move: conflict() says why, and stop_due()
// gives the STOP to send, until a later RESET finds one alone.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/motion/conflict_guard.hpp"
#include "common/motion/device_trust.hpp"
#include "common/motion/sole_writer.hpp"

namespace markservo::motion {

// A few words for people: why what was heard is dropped; empty when it is not.
std::string why_dropped(ReportHeard heard);
std::string why_dropped(StreamHeard heard);

class MoverWatch {
 public:
  // `device` as in robot.yaml's stop_devices.
  explicit MoverWatch(std::string device) : device_(device), trust_(std::move(device)) {}

  const std::string& device() const { return device_; }

  // The device's STOP_STATE.
  ReportHeard hear_stop_state(const Stamp& stamp, bool latched, const std::string& reason);
  // What the device itself reports: JOINT_STATE; WHEEL_ODOMETRY, SONAR_SCAN.
  ReportHeard hear_report(const std::string& channel, const Stamp& stamp);
  // What others tell that its motion is decided by: TARGET_POSE, ROBOT_POSE. Of another writer than the present one
  // only what is of now counts.
  StreamHeard hear_stream(const std::string& channel, const Stamp& stamp);
  // Two that claim to be one were found by other means; `why` names them.
  void raise(const std::string& why) { guard_.raise(why); }

  // us, of the device's newest message; 0 before any.
  std::int64_t now() const { return trust_.newest_utime(); }
  // The session of the device that is believed; 0 before any.
  std::int64_t session() const { return trust_.session(); }
  // How its stop stands; nothing before its first STOP_STATE.
  const std::optional<bool>& latched() const { return latched_; }
  const std::string& stop_reason() const { return stop_reason_; }

  // Why nothing may move though no stop is latched: two claim to be one. Empty when none do.
  const std::string& conflict() const { return guard_.why(); }
  // The STOP to send now.
  std::optional<StopWish> stop_due() { return guard_.due(now()); }

  // "another writes for the arm: session 22 is not heard, 11 is": reports that were dropped within the last second.
  // Empty when none were.
  std::string stranger() const;

 private:
  bool one_alone() const;

  std::string device_;
  DeviceTrust trust_;
  std::map<std::string, SoleWriter> streams_;  // by channel
  ConflictGuard guard_;
  std::optional<bool> latched_;
  std::string stop_reason_;
  std::int64_t stranger_at_ = -1;  // us, of now; -1: none yet
};

}  // namespace markservo::motion
