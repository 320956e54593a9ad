#pragma once

#include <string>
#include <vector>

#include "services/log-tool/log_comparison.hpp"

namespace markservo::log_tool {

// A table of the channels, and the first difference: channel, utime, field, both values.
std::string comparison_text(const LogComparison& comparison, const ComparisonParameters& parameters);

// Why two logs are not the same sequence of (channel, payload): one line; empty when they are.
std::string first_mismatch(const std::vector<logs::LogEvent>& one, const std::vector<logs::LogEvent>& other);

}  // namespace markservo::log_tool
