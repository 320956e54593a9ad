#include "services/simulator/command_gate.hpp"

namespace markservo::simulator {

const char* describe(CommandVerdict verdict) {
  switch (verdict) {
    case CommandVerdict::kObeyed:
      return "obeyed";
    case CommandVerdict::kLatched:
      return "stopped";
    case CommandVerdict::kOtherSession:
      return "answers another session";
    case CommandVerdict::kUnknownFrame:
      return "answers what was not told yet";
    case CommandVerdict::kBeforeReset:
      return "answers what was told before the reset";
    case CommandVerdict::kOutOfOrder:
      return "answers nothing newer than the command before";
    case CommandVerdict::kStale:
      return "answers what is older than 0.3 s";
  }
  return "unknown";
}

void CommandGate::unlatch(std::int64_t newest_seq) {
  latched_ = false;
  after_seq_ = newest_seq;
  last_utime_ = -1;
}

void CommandGate::restart(std::int64_t newest_seq) {
  latched_ = true;
  after_seq_ = newest_seq;
  last_utime_ = -1;
}

CommandVerdict CommandGate::offer(const FrameIdentity& answered, std::int64_t newest_seq, std::int64_t now_utime) {
  if (answered.session != session_) return CommandVerdict::kOtherSession;
  if (answered.seq > newest_seq || answered.utime > now_utime) return CommandVerdict::kUnknownFrame;
  if (latched_) return CommandVerdict::kLatched;
  if (answered.seq <= after_seq_) return CommandVerdict::kBeforeReset;
  if (answered.seq <= last_seq_) return CommandVerdict::kOutOfOrder;
  if (now_utime - answered.utime > kCommandTimeout_us) return CommandVerdict::kStale;
  last_seq_ = answered.seq;
  last_utime_ = now_utime;
  return CommandVerdict::kObeyed;
}

bool CommandGate::silent(std::int64_t now_utime) const {
  return last_utime_ < 0 || now_utime - last_utime_ > kCommandTimeout_us;
}

}  // namespace markservo::simulator
