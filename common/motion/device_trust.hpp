#pragma once

// Whose word counts for a thing that moves. It reports (JOINT_STATE; WHEEL_ODOMETRY and SONAR_SCAN) and says how its
// stop stands (STOP_STATE), all with one session. T, the session of its newest STOP_STATE, is the one to believe.
//
// | state    | heard                                                  | then                                         |
// | -------- | ------------------------------------------------------ | -------------------------------------------- |
// | unknown  | a report                                               | the first heard is believed, and only held   |
// | unknown  | STOP_STATE                                             | trusted: T is its session                    |
// | trusted  | T's STOP_STATE and reports                             | taken                                        |
// | trusted  | a report of a session that never was T                 | foreign: dropped and counted                 |
// | trusted  | STOP_STATE of a new session, latched as movers come up | replaced: T is that session                  |
// | trusted  | STOP_STATE of a new session, released                  | conflict                                     |
// | trusted  | STOP_STATE or report of a session that was T           | conflict: it still lives                     |
// | trusted  | T under a number that it used up, of a later time      | conflict: two with one session               |
// | conflict | STOP_STATE of a session that spoke alone for 1 s       | T is that session; a conflict until settle() |
//
// There is no clock in it: the same messages give the same answers, live and from a log.

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>

#include "common/motion/arrival_order.hpp"
#include "common/motion/stamp.hpp"

namespace markservo::motion {

// What becomes of a report of the device, or of its STOP_STATE.
enum class ReportHeard {
  kTaken,
  kReplaced,  // taken, and T is another than before: what is known of the former no longer holds
  kAnew,      // taken, and the writer's clock began anew: likewise
  kLate,      // late, twice or out of turn: to be dropped
  kForeign,   // of another than T: to be dropped
  kConflict,  // two claim to be the device: conflict() has the words
};

class DeviceTrust {
 public:
  // `device` as in robot.yaml's stop_devices, for the words.
  explicit DeviceTrust(std::string device) : device_(std::move(device)) {}

  ReportHeard hear_stop_state(const Stamp& stamp, bool latched);
  // What the device tells on `channel`.
  ReportHeard hear_report(const std::string& channel, const Stamp& stamp);

  // T, or the session first heard; 0 before any.
  std::int64_t session() const { return session_; }
  // T has said how its stop stands.
  bool trusted() const { return trusted_; }
  // Of T's newest message, us; 0 before any.
  std::int64_t newest_utime() const { return newest_utime_; }
  // Which two claim to be the device; empty when none ever did since settle().
  const std::string& conflict() const { return conflict_; }
  // The newest foreign session; 0 when there was none since settle(). How many such messages were dropped since the
  // start.
  std::int64_t foreign() const { return foreign_session_; }
  std::int64_t foreign_count() const { return foreign_count_; }

  // T alone has been heard for kAlone_s of its own time.
  bool alone() const;
  // The conflict is over: who was T or foreign before is a stranger again.
  void settle();

 private:
  static constexpr double kAlone_s = 1.0;

  // Who has spoken since when without another's word between, by its own time.
  struct Voice {
    std::int64_t session = 0;
    std::int64_t since = 0;   // us
    std::int64_t newest = 0;  // us
  };
  struct Former {
    std::int64_t session;
    std::int64_t newest_utime;  // us, of its last word while it was T
  };

  ReportHeard hear_own(const std::string& channel, const Stamp& stamp);
  ReportHeard not_own(const std::string& channel, const Stamp& stamp, bool claims);
  ReportHeard conflict_with(const std::string& channel, std::int64_t session);
  void become(const Stamp& stamp);
  void hear_voice(const Stamp& stamp);
  bool spoke_alone() const;

  std::string device_;
  std::int64_t session_ = 0;
  bool trusted_ = false;
  std::map<std::string, ArrivalOrder> orders_;  // by channel, of session_
  std::deque<Former> formers_;
  std::string conflict_;
  std::int64_t newest_utime_ = 0;
  Voice voice_;
  std::int64_t foreign_session_ = 0;
  std::int64_t foreign_count_ = 0;
};

}  // namespace markservo::motion
