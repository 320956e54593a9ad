#pragma once

// How long a player waits from event to event, in a log of one clock or of several that are mixed. No clock of its own.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>

#include "common/logs/log_event.hpp"

namespace markservo::log_tool {

// The time goes back by more than this, or on by more than that: a clock was set, or parts stand in the wrong order.
// The player does not wait there. What is less far back is disorder, as of two loggers.
inline constexpr double kLargestStepBack_s = 1.0;
inline constexpr double kLargestGap_s = 86400.0;

// From the newest time so far to an event's.
inline bool jumps(double step_s) {
  return step_s < -kLargestStepBack_s || step_s > kLargestGap_s;
}

// Steps are measured from the newest time, which disorder does not change. Where it jumps, a new time line begins at
// once. A step on that comes to an earlier line's newest time, or beyond it, is the way back to that line: of two mixed
// clocks each step to the other one would else be waited for. There only what lies beyond is waited for, and of that
// no more than was not waited for since.
class TimeWalk {
 public:
  struct Step {
    double due_s = 0.0;     // of the walk, when the event is due: below what was waited where it is late
    double silent_s = 0.0;  // nothing was logged for so long before it, and it is no jump
    bool jumped = false;
  };

  // `longest_gap`: s; where nothing was logged for longer, no longer than that is waited.
  explicit TimeWalk(double longest_gap = std::numeric_limits<double>::infinity()) : longest_gap_(longest_gap) {}

  // To the next event, recorded at `utime`, us.
  Step to(std::int64_t utime) {
    const double step_s = begun_ ? logs::seconds_apart(newest_, utime) : 0.0;
    begun_ = begun_ || begin_at(utime);
    double wait_s = step_s;
    if (const auto line = line_come_to(utime, step_s); line != lines_.end()) {
      wait_s = std::max(0.0, line->second + logs::seconds_apart(line->first, utime) - waited_s_);
      lines_.erase(line);
      leave_line();
      begin_at(utime);
    } else if (jumps(step_s)) {
      leave_line();
      begin_at(utime);
      return {waited_s_, 0.0, true};
    } else if (step_s < 0.0) {
      return {waited_s_ + step_s, 0.0, false};
    }
    newest_ = utime;
    waited_s_ += std::min(wait_s, longest_gap_);
    return {waited_s_, wait_s, false};
  }

  // s, for all events so far.
  double waited_s() const { return waited_s_; }

 private:
  using Lines = std::map<std::int64_t, double>;  // newest time, us: what was waited until then, s

  bool begin_at(std::int64_t utime) {
    newest_ = begin_ = utime;
    return true;
  }

  Lines::iterator line_come_to(std::int64_t utime, double step_s) {
    if (step_s <= kLargestStepBack_s) return lines_.end();
    const auto above = lines_.upper_bound(utime);
    if (above == lines_.begin()) return lines_.end();
    const auto line = std::prev(above);
    return line->first > newest_ && !jumps(logs::seconds_apart(line->first, utime)) ? line : lines_.end();
  }

  // It may be come back to. What is just below it was the same clock's, when it was left before.
  void leave_line() {
    auto line = lines_.insert_or_assign(newest_, waited_s_).first;
    while (line != lines_.begin() && logs::seconds_apart(std::prev(line)->first, begin_) <= kLargestStepBack_s) {
      lines_.erase(std::prev(line));
    }
  }

  double longest_gap_;
  bool begun_ = false;
  std::int64_t begin_ = 0;   // of this line, us
  std::int64_t newest_ = 0;  // of this line
  double waited_s_ = 0.0;
  Lines lines_;  // those that were left
};

}  // namespace markservo::log_tool
