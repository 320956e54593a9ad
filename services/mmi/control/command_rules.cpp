#include "services/mmi/control/command_rules.hpp"

#include <fmt/core.h>

#include "common/time/seconds_between.hpp"

namespace markservo::mmi {

const char* name_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNoToken:
      return "no_token";
    case Refusal::kNoLease:
      return "no_lease";
    case Refusal::kOtherSession:
      return "other_session";
    case Refusal::kReplayed:
      return "replayed";
    case Refusal::kExpired:
      return "expired";
    case Refusal::kTooFarAhead:
      return "too_far_ahead";
    case Refusal::kUnknownTarget:
      return "unknown_target";
    case Refusal::kBusy:
      return "busy";
    case Refusal::kCannot:
      break;
  }
  return "cannot";
}

CommandRules::Verdict CommandRules::judge(const CommandStamp& stamp, std::int64_t now_utime) {
  if (stamp.session != session_) {
    return {false, Refusal::kOtherSession,
            "it is of another conversation; allowed: the session that this one was told"};
  }
  if (stamp.seq <= newest_) {
    return {false, Refusal::kReplayed,
            fmt::format("seq {} came after {}; allowed: each once, in order", stamp.seq, newest_)};
  }
  newest_ = stamp.seq;
  const double left = seconds_between(now_utime, stamp.expires_utime);
  if (left < 0.0) {
    return {false, Refusal::kExpired, fmt::format("it expired {:.1f} s ago: nothing is done late", -left)};
  }
  if (stamp.expires_utime - now_utime > kLongestLife_us) {
    return {false, Refusal::kTooFarAhead,
            fmt::format("it expires in {:.1f} s; allowed: up to {:.0f} s", left, 1e-6 * kLongestLife_us)};
  }
  return {};
}

}  // namespace markservo::mmi
