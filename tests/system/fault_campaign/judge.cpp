#include "tests/system/fault_campaign/invariants.hpp"

namespace markservo::campaign {
namespace {

struct Invariant {
  const char* name;
  Verdict (*judge)(const Timeline&, const Bars&);
  const char* words;
};

constexpr std::array<Invariant, 12> kAll{{
    {"I1", latched_is_still, "0.3 s and the braking after a latch the arm moves less than 0.004 rad, the base 2 mm"},
    {"I2", motion_has_a_goal, "every motion has a goal at most 0.6 s old of the one legal session"},
    {"I3", silence_is_rest, "more than 0.3 s without a fresh command: at rest within the braking way"},
    {"I4", hand_keeps_what_it_lifted, "the hand never opens on a lifted object but for release or home"},
    {"I5", commands_are_within_limits, "no command outside limits, no leap"},
    {"I6", release_needs_a_fresh_reset, "released only by a reset less than 2 s old"},
    {"I7", deaf_or_mute_is_not_ready, "deaf or mute for 5 s is not ready"},
    {"I8", recovers_unaided, "fault gone: all ready within 15 s, memory within 10 MB, bus bytes within 10%"},
    {"I9", tasks_end_with_the_reason, "every task ends with a reason that names the fault's channel or process"},
    {"I10", recording_goes_on, "the recording is readable up to the fault and goes on"},
    {"I11", words_are_clean, "nothing printed or logged holds control characters"},
    {"I12", touches_only_the_target, "nothing is touched but the target"},
}};

}  // namespace

void note(Verdict& verdict, std::int64_t t, const std::string& evidence) {
  if (verdict.breaches.size() < kMostBreaches) verdict.breaches.push_back({t, evidence});
}

std::map<std::string, Verdict> judge(const Timeline& timeline, const Bars& bars) {
  std::map<std::string, Verdict> verdicts;
  for (const Invariant& invariant : kAll) {
    bool excused = false;
    for (const Fault& fault : timeline.faults) excused = excused || fault.excuses.count(invariant.name) > 0;
    verdicts[invariant.name] = excused ? Verdict{} : invariant.judge(timeline, bars);
  }
  return verdicts;
}

const char* words_of(const std::string& invariant) {
  for (const Invariant& one : kAll) {
    if (invariant == one.name) return one.words;
  }
  return "";
}

}  // namespace markservo::campaign
