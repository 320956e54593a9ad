#pragma once

#include <vector>

#include "common/logs/log_event.hpp"

namespace markservo::log_tool {

// The recorded log with its messages on the channels of `derived` replaced by those of `derived`: what the next service
// of a chain would have heard. Each stands where its counterpart stood; one that has none, behind the last recorded
// message with its utime, else behind the derived one before it.
std::vector<logs::LogEvent> spliced(const std::vector<logs::LogEvent>& recorded,
                                    const std::vector<logs::LogEvent>& derived);

}  // namespace markservo::log_tool
