#include "common/motion/command_gate.hpp"

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

const char* describe(CommandVerdict verdict) {
  switch (verdict) {
    case CommandVerdict::kObeyed:
      return "is obeyed";
    case CommandVerdict::kLatched:
      return "comes while STOP is latched";
    case CommandVerdict::kOtherMover:
      return "was made for another mover, or an earlier run of this one";
    case CommandVerdict::kBeforeReset:
      return "answers what was measured before the reset";
    case CommandVerdict::kStale:
      return "answers what was measured more than 0.3 s ago";
    case CommandVerdict::kAhead:
      return "answers what is not measured yet";
    case CommandVerdict::kOutOfOrder:
      return "comes late or twice";
    case CommandVerdict::kWaits:
      return "is of a second writer, while the first still speaks";
    case CommandVerdict::kLeads:
      return "leads the shafts by more than 0.3 s at its speed limit and 0.1 rad";
    case CommandVerdict::kJumps:
      return "jumps away from the command before it, by more than its speed limit allows and 0.035 rad";
    case CommandVerdict::kTwoWriters:
      return "is of one of two writers";
  }
  return "is unknown";
}

CommandVerdict CommandGate::hear(const OfferedCommand& command, std::int64_t now, bool latched) {
  if (command.made_for != session_) return CommandVerdict::kOtherMover;
  released_at_ = std::min(released_at_, now);  // a clock that was set back
  const double age = seconds_between(command.stamp.utime, now);
  // A time that cannot be tells nothing of who writes.
  if (-age > parameters_.ahead) return CommandVerdict::kAhead;
  if (age > parameters_.life) return CommandVerdict::kStale;
  switch (writer_.hear(command.stamp, now)) {
    case StreamHeard::kSecond:
      return CommandVerdict::kTwoWriters;
    case StreamHeard::kLate:
      return latched ? CommandVerdict::kLatched : CommandVerdict::kOutOfOrder;
    case StreamHeard::kWaits:
      return latched ? CommandVerdict::kLatched : CommandVerdict::kWaits;
    case StreamHeard::kTaken:
    case StreamHeard::kAnew:
      break;
  }
  if (latched) return CommandVerdict::kLatched;
  if (command.stamp.utime <= released_at_) return CommandVerdict::kBeforeReset;
  if (command.leads) return CommandVerdict::kLeads;
  if (command.jumps) return CommandVerdict::kJumps;
  obeyed_at_ = now;
  return CommandVerdict::kObeyed;
}

void CommandGate::release(std::int64_t now) {
  released_at_ = now;
  obeyed_at_ = -1;
  writer_.settle();
}

std::string CommandGate::obstacle(std::int64_t now) const {
  return writer_.alone(now) ? "" : writer_.words() + "; released only when one has been silent for 1 s";
}

bool CommandGate::silent(std::int64_t now) const {
  // A clock that was set back does not tell how long it has been silent.
  return obeyed_at_ < 0 || now < obeyed_at_ || seconds_between(obeyed_at_, now) > parameters_.life;
}

}  // namespace markservo::motion
