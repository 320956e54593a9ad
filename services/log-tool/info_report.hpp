#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "common/logs/log_files.hpp"
#include "services/log-tool/channel_statistics.hpp"

namespace markservo::log_tool {

// What is in a log: for people, a table; for programs, JSON.
std::string info_text(const logs::LogSet& logs, const LogSummary& summary);
nlohmann::ordered_json info_json(const logs::LogSet& logs, const LogSummary& summary);

// One line for each damage, and for each channel with messages that cannot be decoded.
std::string damage_text(const logs::LogSet& logs, const LogSummary& summary);

}  // namespace markservo::log_tool
