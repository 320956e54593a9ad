#pragma once

// Which JOINT_COMMANDs an arm obeys, and which BASE_COMMANDs a base: what every driver holds to. It knows no frames,
// for a driver reads none: a command is ordered by its writer's session and seq, its age is that of the measurement it
// answers, and it must be made for this mover: from a report of the mover's own session.
//
// | state    | command                                                       | verdict                     |
// | -------- | ------------------------------------------------------------- | --------------------------- |
// | any      | made from another session's reports                           | other mover                 |
// | any      | of the writer that had the floor, after another spoke         | two writers: latch and say so |
// | latched  | any other                                                     | latched                     |
// | released | answers a measurement from before the release                 | before reset                |
// | released | answers a measurement more than 0.3 s ago                     | stale                       |
// | released | answers a measurement ahead of the mover's time               | ahead                       |
// | released | not above the writer's last seq, or of before its last time   | out of order                |
// | released | of another writer while the first still speaks                | waits                       |
// | released | too far ahead of the shafts                                   | leads                       |
// | released | too far from the command before it                            | jumps                       |
// | released | any other                                                     | obeyed                      |

#include <cstdint>
#include <string>

#include "common/motion/sole_writer.hpp"
#include "common/motion/stamp.hpp"

namespace markservo::motion {

struct OfferedCommand {
  Stamp stamp;                // its writer's session and seq; utime of the measurement that it answers
  std::int64_t made_for = 0;  // session of the mover's report that it was made from
  bool leads = false;         // leading_joint() found one: it is too far ahead of the shafts to be meant for them
  bool jumps = false;         // CommandPath::jumping_joint() found one: it does not continue the command before it
};

enum class CommandVerdict {
  kObeyed,
  kLatched,      // STOP holds the mover
  kOtherMover,   // made for another mover, or an earlier run of this one
  kBeforeReset,  // answers what was measured before the STOP reset
  kStale,        // answers what was measured more than 0.3 s ago
  kAhead,        // answers what is not measured yet
  kOutOfOrder,   // comes late or twice
  kLeads,        // too far ahead of the shafts
  kJumps,        // too far from the command before it
  kWaits,        // of a second writer, while the first still speaks
  kTwoWriters,   // the first spoke again: the mover must latch
};

// A few words for people: "is older than 0.3 s".
const char* describe(CommandVerdict verdict);

struct CommandGateParameters {
  double life = 0.3;    // s; older or missing commands stop motion
  double ahead = 0.02;  // s by which hosts' clocks may disagree
  WriterParameters writer;
};

class CommandGate {
 public:
  // `channel` for the words; `session`: of this mover's own reports.
  CommandGate(const std::string& channel, std::int64_t session, CommandGateParameters parameters = {})
      : session_(session), parameters_(parameters), writer_(channel, parameters.writer) {}

  // Judges a command that arrives at `now` (us, the mover's time). `latched`: whether STOP holds the mover.
  CommandVerdict hear(const OfferedCommand& command, std::int64_t now, bool latched);

  // The stop was reset at `now`: only commands that answer later measurements count.
  void release(std::int64_t now);

  // Why the stop cannot be reset: two writers have spoken within the last second. Empty when it can.
  std::string obstacle(std::int64_t now) const;
  // Which two write.
  std::string two_writers() const { return writer_.words(); }

  // True if the last obeyed command is more than `life` ago, or there was none since the release.
  bool silent(std::int64_t now) const;

 private:
  std::int64_t session_;
  CommandGateParameters parameters_;
  SoleWriter writer_;
  std::int64_t released_at_ = -1;  // us; -1: never
  std::int64_t obeyed_at_ = -1;    // us, when the last obeyed one came; -1: none since the release
};

}  // namespace markservo::motion
