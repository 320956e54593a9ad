#include "services/recorder/recording_end.hpp"

#include <spdlog/fmt/fmt.h>

namespace markservo::recorder {

std::string text_of(EndReason reason) {
  switch (reason) {
    case EndReason::kTold:
      return "told to";
    case EndReason::kTimeIsUp:
      return "time is up";
    case EndReason::kDiskNearlyFull:
      return "disk nearly full";
    case EndReason::kDiskFull:
      return "disk full";
    case EndReason::kLoggerFailed:
      return "logger failed";
    case EndReason::kKilled:
      return "killed";
  }
  return {};
}

std::optional<EndReason> reason_to_end(const RecordingPlan& plan, const Moment& now) {
  constexpr std::int64_t kSecond_us = 1'000'000;
  if (now.told) return EndReason::kTold;
  if (plan.duration_s && now.recorded_us >= *plan.duration_s * kSecond_us) return EndReason::kTimeIsUp;
  if (now.free_mb < plan.min_free_mb) return EndReason::kDiskNearlyFull;
  return std::nullopt;
}

EndReason reason_in_the_end(EndReason reason, const LoggerEnd& logger, bool disk_is_full) {
  if (logger.is_well()) return reason;
  if (disk_is_full) return EndReason::kDiskFull;
  return reason == EndReason::kDiskNearlyFull ? reason : EndReason::kLoggerFailed;
}

std::optional<std::string> fault_of(EndReason reason, const LoggerEnd& logger, const RecordingPlan& plan,
                                    std::int64_t free_mb) {
  switch (reason) {
    case EndReason::kTold:
    case EndReason::kTimeIsUp:
      return std::nullopt;
    case EndReason::kDiskNearlyFull:
      return fmt::format("only {} MB are free on the disk, less than --min-free {}", free_mb, plan.min_free_mb);
    case EndReason::kDiskFull:
      return "the disk is full";
    case EndReason::kLoggerFailed:
    case EndReason::kKilled:
      return text_of(logger);
  }
  return std::nullopt;
}

}  // namespace markservo::recorder
