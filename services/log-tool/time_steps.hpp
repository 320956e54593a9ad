#pragma once

// How a log's time goes from event to event, and what the player does about it.

#include <cstdint>
#include <vector>

#include "common/logs/log_event.hpp"

namespace markservo::log_tool {

// Less out of order is every recording with large messages: their time is their first packet's. Not worth a word.
inline constexpr double kDisorder_s = 0.1;

// Longer than this nothing was logged at all: worth a word.
inline constexpr double kSilence_s = 10.0;

struct Silence {
  double after = 0.0;    // s since the log's first event, as the times of a cut
  double seconds = 0.0;  // to the next event
};

struct TimeSteps {
  std::int64_t back = 0;          // events that are earlier than the one before
  double farthest_back = 0.0;     // s that an event is earlier than the newest before it
  std::int64_t late = 0;          // events that are earlier than some event before: what sorting would move
  std::int64_t jumps = 0;         // where the player does not wait, see time_walk.hpp
  std::vector<Silence> silences;  // above kSilence_s, without the jumps, in the log's order
};

TimeSteps time_steps(const std::vector<logs::LogEvent>& events);

// By time; of one time in the order that they had. Numbered anew.
std::vector<logs::LogEvent> sorted_by_time(std::vector<logs::LogEvent> events);

// "3.5 ms" below 0.1 s, "12.3 s", above two minutes "3.5 min"; "2.1 h", "40 days".
std::string duration_text(double seconds);

// "1 time back, by 3.9 s: 20 events are out of order"; empty where none is.
std::string disorder_text(const TimeSteps& steps);

// "nothing for 3.5 min after 12.3 s, for 20.0 s after 300.0 s and 2 more times"; empty where there is no silence.
std::string silences_text(const TimeSteps& steps);

}  // namespace markservo::log_tool
