#pragma once

// Which commands a mover may obey, told from the history alone: those that answer its own newest measurements, of the
// one session that writes. What a second one says beside it is never fresh, and makes two writers of the channel.

#include <cstdint>
#include <vector>

#include "tests/system/fault_campaign/invariants.hpp"

namespace markservo::campaign {

// A JOINT_COMMAND or BASE_COMMAND as it was heard.
struct OfferedCommand {
  std::int64_t t = 0;        // us, when it was heard
  double world = 0.0;        // s
  std::int64_t session = 0;  // of the writer
  std::int64_t seq = 0;
  std::int64_t stamp = 0;     // us, of the measurement that it answers
  std::int64_t made_for = 0;  // the mover's session
  bool foreign = false;
  bool meant = false;     // its every value is possible, so that a mover cannot but take it for a command
  bool can_move = false;  // it is made of numbers, and no leap from where the shafts are
};

// Who wrote when another did.
struct TwoWriters {
  std::int64_t t = 0;  // us, when it was plain
  double world = 0.0;  // s
  std::int64_t first = 0;
  std::int64_t second = 0;
};

struct Commands {
  std::vector<double> fresh;          // s, world, growing: when each was heard that the mover may obey
  std::vector<double> strangers;      // s, world, growing: those of them that the trial gave, writing alone
  std::vector<TwoWriters> conflicts;  // those in which the trial itself was one of the two
};

// s, until a base that moves so stands.
double base_braking(const SimBaseTruth& truth, const Bars& bars);

std::vector<OfferedCommand> offered_to_arm(const Timeline& timeline, const Bars& bars);
std::vector<OfferedCommand> offered_to_base(const Timeline& timeline, const Bars& bars);
// Whether somebody else than the stack moves the device between `from` and `to` (s, world): one who writes alone, or
// one of two whom a mover cannot yet know to be two. Each for `moment` s after the word.
bool moved_by_a_stranger(const Commands& commands, double from, double to, double moment, const Bars& bars);
// `device` as STOP_STATE names it.
Commands judged_as_the_mover(const Timeline& timeline, const std::vector<OfferedCommand>& offered, const char* device,
                             const Bars& bars);

}  // namespace markservo::campaign
