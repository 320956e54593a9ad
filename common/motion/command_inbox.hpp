#pragma once

// Commands of people and programs (RESET, START, HOME, world resets): repeated until they are echoed, executed at most
// once, and only while they are fresh. STOP and ABORT are obeyed whatever their age, and by who hears them also when
// heard again, where they find something to stop.
//
// | heard                                             | then                                                     |
// | ------------------------------------------------- | -------------------------------------------------------- |
// | an id at or below the last executed of its sender | again: echoed, not executed                              |
// | too old or too far ahead by the mover's time      | stale: neither executed nor echoed; it may come fresh    |
// | any other                                         | execute                                                  |

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

#include "common/motion/freshness.hpp"

namespace markservo::motion {

struct CommandStamp {
  std::int64_t session = 0;
  std::int64_t id = 0;
  std::int64_t utime = 0;  // us, as the sender last heard the mover's time
};

enum class CommandHeard { kExecute, kAgain, kStale };

class CommandInbox {
 public:
  // `channel` and `clock` (whose time the mover's is) for the words.
  CommandInbox(const char* channel, const char* clock) : rule_{channel, clock, kCommandAge_s, kCommandAge_s} {}

  // `now`: us, the mover's time. `always`: of any age, and echoed whenever it is heard.
  CommandHeard hear(const CommandStamp& command, std::int64_t now, bool always);

  // Why a command is stale at `now`; empty when it is not.
  std::string why_stale(const CommandStamp& command, std::int64_t now) const {
    return why_not_fresh(rule_, command.utime, now);
  }

  // What to echo: the last executed command; 0 before the first.
  std::int64_t session() const { return session_; }
  std::int64_t id() const { return id_; }

 private:
  struct Sender {
    std::int64_t session;
    std::int64_t last_id;
  };

  Freshness rule_;
  std::deque<Sender> senders_;  // the one that spoke last at the end
  std::int64_t session_ = 0;
  std::int64_t id_ = 0;
};

}  // namespace markservo::motion
