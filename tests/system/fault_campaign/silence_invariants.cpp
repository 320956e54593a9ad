// I3: without a fresh command of the one who may give it, a mover rests.

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/mover.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// The last of `times` (growing) that is not after `world`; where there is none, nobody ever spoke: the world's begin.
double last_before(const std::vector<double>& times, double world) {
  const auto after = std::upper_bound(times.begin(), times.end(), world);
  return after == times.begin() ? 0.0 : *std::prev(after);
}

int count_silences(const std::vector<double>& times, double longest) {
  int silences = 0;
  for (std::size_t i = 1; i < times.size(); ++i) silences += times[i] - times[i - 1] > longest ? 1 : 0;
  return silences;
}

void judge_arm_silence(const Timeline& timeline, const std::vector<double>& times, const Bars& bars, Verdict& verdict) {
  verdict.judged += count_silences(times, bars.command_age);
  double moved = 0.0;  // rad, in the present silence
  double silent_since = -1.0;
  for (const ArmStep& step : arm_steps(timeline)) {
    const auto last = last_before(times, step.to->world);
    if (silent_since != last) moved = 0.0;
    silent_since = last;
    if (step.from->world - last <= bars.command_age + bars.hearing + bars.arm_braking) continue;
    ++verdict.judged;
    moved += step.way;
    if (moved <= bars.arm_still_rad) continue;
    note(verdict, step.to->t,
         text("no fresh JOINT_COMMAND since %.2f s (world), and the arm moved %.4f rad until %.2f s", last, moved,
              step.to->world));
    moved = 0.0;
  }
}

void judge_base_silence(const Timeline& timeline, const std::vector<double>& times, const Bars& bars,
                        Verdict& verdict) {
  constexpr double kBraking = -1.0;  // it is not yet known when that will be over
  verdict.judged += count_silences(times, bars.command_age);
  const Heard<SimBaseTruth>* rest = nullptr;
  const Heard<SimBaseTruth>* before = nullptr;
  double rest_from = kBraking;  // s, world
  double silent_since = -1.0;
  for (const auto& truth : timeline.base_truth) {
    const auto last = last_before(times, truth.world);
    const bool goes_on = before != nullptr && before->message.session == truth.message.session && silent_since == last;
    before = &truth;
    silent_since = last;
    if (!goes_on) {
      rest = nullptr;
      rest_from = kBraking;
    }
    if (truth.world - last <= bars.command_age + bars.hearing) continue;
    if (rest_from < 0.0) rest_from = truth.world + base_braking(truth.message, bars);
    if (truth.world < rest_from) continue;
    if (rest == nullptr) rest = &truth;
    ++verdict.judged;
    const std::string moved = base_moved(rest->message, truth.message, bars.base_silent_m, bars.base_silent_rad);
    if (moved.empty()) continue;
    note(verdict, truth.t,
         text("no fresh BASE_COMMAND since %.2f s (world), and the base %s until %.2f s", last, moved.c_str(),
              truth.world));
    rest = &truth;
  }
}

// From when to when two writers hold a device: until a RESET that was not obeyed before is echoed, or its mover is
// gone.
struct Held {
  TwoWriters writers;
  std::int64_t session = 0;  // of the mover
  std::int64_t until = 0;    // us
};

std::vector<Held> held_by_two(const Timeline& timeline, const std::vector<TwoWriters>& conflicts, const char* device) {
  std::vector<Held> all;
  for (const TwoWriters& two : conflicts) {
    if (!all.empty() && two.t < all.back().until) continue;
    Held held{two, 0, timeline.ended_at};
    std::pair<std::int64_t, std::int64_t> echoed{0, 0};  // request that the mover had obeyed
    for (const auto& heard : timeline.stop_states) {
      const StopState& state = heard.message;
      if (heard.foreign || state.device != device || !timeline.is("simulator", state.session)) continue;
      const std::pair<std::int64_t, std::int64_t> told{state.request_session, state.request_id};
      if (heard.t <= two.t) {
        held.session = state.session;
        echoed = told;
      } else if (state.session != held.session || (!state.latched && told != echoed)) {
        held.until = heard.t;
        break;
      }
    }
    all.push_back(held);
  }
  return all;
}

void judge_arm_of_two(const Timeline& timeline, const Commands& commands, const Bars& bars, Verdict& verdict) {
  for (const Held& held : held_by_two(timeline, commands.conflicts, "arm")) {
    const double from = held.writers.world + bars.latch_time + bars.arm_braking + bars.hearing;
    const Heard<SimTruth>* rest = nullptr;
    for (const auto& truth : timeline.truth) {
      if (truth.message.session != held.session || truth.world < from || truth.t >= held.until) continue;
      if (rest == nullptr || !same_world(rest->message, truth.message)) rest = &truth;
      ++verdict.judged;
      const double way = farthest_joint(rest->message.shaft, truth.message.shaft);
      if (way <= bars.arm_still_rad) continue;
      note(verdict, truth.t,
           text("two write JOINT_COMMAND since %.2f s (world), sessions %ld and %ld, and the arm moved %.4f rad by "
                "%.2f s without a RESET",
                held.writers.world, static_cast<long>(held.writers.first), static_cast<long>(held.writers.second), way,
                truth.world));
      break;
    }
  }
}

void judge_base_of_two(const Timeline& timeline, const Commands& commands, const Bars& bars, Verdict& verdict) {
  for (const Held& held : held_by_two(timeline, commands.conflicts, "base")) {
    double from = held.writers.world + bars.latch_time + bars.hearing;
    bool braking_known = false;
    const Heard<SimBaseTruth>* rest = nullptr;
    for (const auto& truth : timeline.base_truth) {
      if (truth.message.session != held.session || truth.world < from || truth.t >= held.until) continue;
      if (!braking_known) from += base_braking(truth.message, bars);
      braking_known = true;
      if (truth.world < from) continue;
      if (rest == nullptr) rest = &truth;
      ++verdict.judged;
      const std::string moved = base_moved(rest->message, truth.message, bars.base_silent_m, bars.base_silent_rad);
      if (moved.empty()) continue;
      note(
          verdict, truth.t,
          text("two write BASE_COMMAND since %.2f s (world), sessions %ld and %ld, and the base %s by %.2f s without a "
               "RESET",
               held.writers.world, static_cast<long>(held.writers.first), static_cast<long>(held.writers.second),
               moved.c_str(), truth.world));
      break;
    }
  }
}

}  // namespace

Verdict silence_is_rest(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  // Commands of another version of the type tell nothing.
  const auto unknown = [&](const char* channel, bool none) { return none && timeline.traffic.count(channel) > 0; };
  if (unknown("JOINT_COMMAND", timeline.joint_commands.empty())) return verdict;
  const auto to_arm = offered_to_arm(timeline, bars);
  const Commands arm = judged_as_the_mover(timeline, to_arm, "arm", bars);
  judge_arm_silence(timeline, arm.fresh, bars, verdict);
  judge_arm_of_two(timeline, arm, bars, verdict);
  const auto to_base = offered_to_base(timeline, bars);
  const Commands base = judged_as_the_mover(timeline, to_base, "base", bars);
  judge_base_silence(timeline, base.fresh, bars, verdict);
  judge_base_of_two(timeline, base, bars, verdict);
  return verdict;
}

}  // namespace markservo::campaign
