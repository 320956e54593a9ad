#pragma once

// Lines of this program's log, where bus::set_up_log() lets them go. They are formatted as fmt does:
//
//   logging::warn("{}: {} of {} marks are left out", channel, dropped, all);
//
// Without spdlog's header: a file that logs by that takes the compiler 3 s longer.

#include <fmt/core.h>

namespace markservo::logging {

enum class Severity { kDebug, kInfo, kWarn, kError };

// One line, if `severity` is logged.
void write(Severity severity, fmt::string_view format, fmt::format_args values);

template <class... Values>
void debug(fmt::format_string<Values...> format, const Values&... values) {
  write(Severity::kDebug, format, fmt::make_format_args(values...));
}
template <class... Values>
void info(fmt::format_string<Values...> format, const Values&... values) {
  write(Severity::kInfo, format, fmt::make_format_args(values...));
}
template <class... Values>
void warn(fmt::format_string<Values...> format, const Values&... values) {
  write(Severity::kWarn, format, fmt::make_format_args(values...));
}
template <class... Values>
void error(fmt::format_string<Values...> format, const Values&... values) {
  write(Severity::kError, format, fmt::make_format_args(values...));
}

}  // namespace markservo::logging
