#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "services/recorder/logger/logger_end.hpp"
#include "services/recorder/recording_plan.hpp"

namespace markservo::recorder {

// Why a recording ended.
enum class EndReason {
  kTold,
  kTimeIsUp,
  kDiskNearlyFull,  // less than --min-free is left
  kDiskFull,        // lcm-logger could not write
  kLoggerFailed,    // and said so by its exit code
  kKilled,          // its script was; found out later
};

// As the manifest has it: "time is up".
std::string text_of(EndReason reason);

// What is looked at twice a second.
struct Moment {
  bool told = false;             // to end
  std::int64_t recorded_us = 0;  // since it began
  std::int64_t free_mb = 0;      // on the disk
};

// Why the recording shall end now; nothing: it shall go on.
std::optional<EndReason> reason_to_end(const RecordingPlan& plan, const Moment& now);

// Why it ended, once lcm-logger has ended as well: `reason` is why it was to end; `disk_is_full`: lcm-logger said so.
EndReason reason_in_the_end(EndReason reason, const LoggerEnd& logger, bool disk_is_full);

// What went wrong, in words; nothing where it ended as it should.
std::optional<std::string> fault_of(EndReason reason, const LoggerEnd& logger, const RecordingPlan& plan,
                                    std::int64_t free_mb);

}  // namespace markservo::recorder
