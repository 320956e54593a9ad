#pragma once

// What a seed does: a phase of the robot's work, and the faults that strike in it. The same seed gives the same plan on
// any machine.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace markservo::campaign {

// One fault's kind and numbers; a kind looks at those that mean something to it.
struct FaultPlan {
  std::string kind;
  std::string channel;
  std::string service;
  std::string variant;
  double offset = 0.0;    // s, from the phase's moment to the strike
  double duration = 1.0;  // s
  double rate = 0.0;      // messages a second
  double percent = 0.0;   // of messages or packets
  double delay = 0.0;     // s
  double amount = 0.0;    // the kind's own: s, rad, bytes
  bool same_session = false;
};

struct Plan {
  std::int64_t seed = 0;
  int draw = 0;  // how often the seed was drawn again: its phase was not reached, or a fault struck nothing
  std::string phase;
  double phase_delay = 0.0;  // s, from the phase's begin to its moment
  std::vector<FaultPlan> faults;
};

// "idle", "drive", "approach", "servo", "grip", "lifted", "carry".
const std::vector<std::string>& phases();
// All kinds of fault that can be drawn.
const std::vector<std::string>& fault_kinds();

Plan plan_of(std::int64_t seed, int draw);
// One fault alone in `phase`, for trying it: `wanted` is its kind and, after colons, any of its channel, service,
// variant and session (`same`, `other`), as "second-writer:JOINT_STATE:other"; its numbers are drawn from `seed`.
// Throws std::invalid_argument for what there is not.
Plan plan_with(std::int64_t seed, const std::string& wanted, const std::string& phase);

nlohmann::json json_of(const FaultPlan& fault);

}  // namespace markservo::campaign
