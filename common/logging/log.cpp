#include "common/logging/log.hpp"

#include <spdlog/spdlog.h>

namespace markservo::logging {
namespace {

spdlog::level::level_enum level_of(Severity severity) {
  switch (severity) {
    case Severity::kDebug:
      return spdlog::level::debug;
    case Severity::kInfo:
      return spdlog::level::info;
    case Severity::kWarn:
      return spdlog::level::warn;
    case Severity::kError:
      break;
  }
  return spdlog::level::err;
}

}  // namespace

void write(Severity severity, fmt::string_view format, fmt::format_args values) {
  spdlog::logger* logger = spdlog::default_logger_raw();
  const spdlog::level::level_enum level = level_of(severity);
  if (!logger->should_log(level)) return;
  try {
    logger->log(level, spdlog::string_view_t(fmt::vformat(format, values)));
  } catch (const fmt::format_error&) {
    logger->log(level, format);  // no line of log ends a service
  }
}

}  // namespace markservo::logging
