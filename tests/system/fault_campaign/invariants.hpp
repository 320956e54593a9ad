#pragma once

// What must hold in every trial, whatever struck. Pure functions of the history.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/bars.hpp"
#include "tests/system/fault_campaign/timeline.hpp"

namespace markservo::campaign {

struct Breach {
  std::int64_t t = 0;  // us, when
  std::string evidence;
};

struct Verdict {
  std::int64_t judged = 0;  // how often the invariant was put to the test
  std::vector<Breach> breaches;

  bool broken() const { return !breaches.empty(); }
};

inline constexpr std::size_t kMostBreaches = 5;  // of one invariant: the first ones tell
void note(Verdict& verdict, std::int64_t t, const std::string& evidence);

// The bus's load after the faults, of I8. `ready_since`: us, from when on the stack was whole before them.
void judge_load(const Timeline& timeline, std::int64_t ready_since, const Bars& bars, Verdict& verdict);

Verdict latched_is_still(const Timeline& timeline, const Bars& bars);             // I1
Verdict motion_has_a_goal(const Timeline& timeline, const Bars& bars);            // I2
Verdict silence_is_rest(const Timeline& timeline, const Bars& bars);              // I3
Verdict hand_keeps_what_it_lifted(const Timeline& timeline, const Bars& bars);    // I4
Verdict commands_are_within_limits(const Timeline& timeline, const Bars& bars);   // I5
Verdict release_needs_a_fresh_reset(const Timeline& timeline, const Bars& bars);  // I6
Verdict deaf_or_mute_is_not_ready(const Timeline& timeline, const Bars& bars);    // I7
Verdict recovers_unaided(const Timeline& timeline, const Bars& bars);             // I8
Verdict tasks_end_with_the_reason(const Timeline& timeline, const Bars& bars);    // I9
Verdict recording_goes_on(const Timeline& timeline, const Bars& bars);            // I10
Verdict words_are_clean(const Timeline& timeline, const Bars& bars);              // I11
Verdict touches_only_the_target(const Timeline& timeline, const Bars& bars);      // I12

// All of them, "I1" to "I12". An invariant that a fault excuses is not judged.
std::map<std::string, Verdict> judge(const Timeline& timeline, const Bars& bars);
inline constexpr std::array<const char*, 12> kInvariants = {"I1", "I2", "I3", "I4",  "I5",  "I6",
                                                            "I7", "I8", "I9", "I10", "I11", "I12"};
// What it demands, in a line.
const char* words_of(const std::string& invariant);

}  // namespace markservo::campaign
