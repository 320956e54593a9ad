#pragma once

#include <cstdint>
#include <string>

#include "services/mmi/control/command.hpp"

namespace markservo::mmi {

// Why a command is refused, by name.
enum class Refusal {
  kNoToken,
  kNoLease,
  kOtherSession,
  kReplayed,
  kExpired,
  kTooFarAhead,
  kCannot,
  kUnknownTarget,
  kBusy
};

// "no_token", ...
const char* name_of(Refusal refusal);

// One conversation's commands: each is of this conversation, comes in its turn, once, and in time.
class CommandRules {
 public:
  static constexpr std::int64_t kLongestLife_us = 2'000'000;  // what is clicked is obeyed within it, or never

  explicit CommandRules(std::int64_t session) : session_(session) {}

  struct Verdict {
    bool good = true;
    Refusal refusal = Refusal::kCannot;
    std::string text;  // for people
  };
  // `now_utime`: us, of the clock by which commands expire. What is refused has used its number up as well.
  Verdict judge(const CommandStamp& stamp, std::int64_t now_utime);

 private:
  std::int64_t session_;
  std::int64_t newest_ = 0;
};

}  // namespace markservo::mmi
