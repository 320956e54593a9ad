#pragma once

// The stop of what moves: latched from the start, by anyone's STOP and by the mover itself; released by a fresh RESET
// alone. The words of STOP_STATE come from here.
//
// | state    | event                               | then                                    |
// | -------- | ----------------------------------- | --------------------------------------- |
// | latched  | RESET, fresh                        | released, unless two command the mover  |
// | released | any STOP; the mover's own           | latched                                 |
// | any      | RESET older or newer than 2 s       | stays; not echoed                       |
// | latched  | RESET of before the newest STOP     | stays; not echoed                       |
// | any      | a RESET that was executed before    | stays; echoed                           |
// | latched  | a STOP that was executed before     | stays; echoed                           |

#include <cstdint>
#include <limits>
#include <string>

#include "common/motion/command_inbox.hpp"

namespace markservo::motion {

// One STOP message.
struct StopRequestStamp {
  CommandStamp stamp;
  bool reset = false;
  std::string words;  // who asks and why, for people
};

enum class StopHeard {
  kLatched,   // a STOP was executed
  kReleased,  // a RESET was executed
  kRefused,   // a RESET was executed in vain: it is still latched, reason() says why
  kAgain,     // executed before: only to be echoed
  kStale,     // a RESET out of time: why_stale() has the words
};

class StopLatch {
 public:
  // `clock`: the channel that carries the mover's time, for the words.
  explicit StopLatch(const char* clock) : inbox_("STOP", clock) {}

  // `now`: us, the mover's time. `obstacle`: why it cannot be released now; empty when it can.
  StopHeard hear(const StopRequestStamp& request, std::int64_t now, const std::string& obstacle = {});
  std::string why_stale(const StopRequestStamp& request, std::int64_t now) const;

  // Latches by the mover itself at `now` (us): two command it, the world begins anew.
  void latch(const std::string& reason, std::int64_t now);

  bool latched() const { return latched_; }
  const std::string& reason() const { return reason_; }
  // The request that STOP_STATE echoes.
  std::int64_t session() const { return inbox_.session(); }
  std::int64_t id() const { return inbox_.id(); }

 private:
  CommandInbox inbox_;
  bool latched_ = true;
  std::int64_t latched_at_ = std::numeric_limits<std::int64_t>::min();  // us, when it was last told to stop
  std::string reason_ = "comes up stopped";
};

}  // namespace markservo::motion
