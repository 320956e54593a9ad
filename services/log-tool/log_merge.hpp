#pragma once

#include <string>
#include <vector>

#include "common/logs/log_event.hpp"

namespace markservo::log_tool {

// One of the logs that are merged.
struct MergeInput {
  std::string name;
  std::vector<logs::LogEvent> events;
};

struct Merge {
  std::vector<logs::LogEvent> events;  // of all inputs, by time; of one time in the inputs' order
  std::int64_t late = 0;               // events that were out of order within their input
  std::int64_t twice = 0;  // messages of one channel and content that another input has too, liblcm's own apart
  std::vector<std::string> remarks;  // what may be wrong with it, a line each
};

// Puts logs together by their events' times, or sorts one. Nothing is left out. Remarks where two logs do not overlap
// in time (their clocks may differ), and where more than a few messages are the same (two recordings of one bus).
Merge merged(const std::vector<MergeInput>& inputs);

}  // namespace markservo::log_tool
