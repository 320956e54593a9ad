#include "services/recorder/logger/logger_end.hpp"

#include <spdlog/fmt/fmt.h>

#include <cstring>

namespace markservo::recorder {
namespace {

// Above 128 and the last signal, which would say that keep-logger's caller was a shell that a signal ended.
constexpr int kKilledCode = 192;

}  // namespace

int keeper_exit_code(const LoggerEnd& end) {
  return end.by_signal ? kKilledCode + end.number : end.number;
}

LoggerEnd told_by_keeper(int exit_code) {
  const bool by_signal = exit_code > kKilledCode;
  return {LoggerEnd::Who::kLogger, by_signal, by_signal ? exit_code - kKilledCode : exit_code};
}

std::string text_of(const LoggerEnd& end) {
  if (!end.by_signal) return fmt::format("lcm-logger ended with exit code {}", end.number);
  const char* who = end.who == LoggerEnd::Who::kLogger ? "lcm-logger" : "keep-logger, which runs lcm-logger,";
  const char* name = sigabbrev_np(end.number);
  return fmt::format("{} was killed by signal {} (SIG{})", who, end.number, name != nullptr ? name : "?");
}

}  // namespace markservo::recorder
