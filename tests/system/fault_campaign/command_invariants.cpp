// I5 and I6: what may be commanded, and what releases.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

bool within(double value, const std::vector<double>& low, const std::vector<double>& high, std::size_t i,
            double rounding) {
  return i >= low.size() || (value >= low[i] - rounding && value <= high[i] + rounding);
}

std::string wrong_joint(const JointCommand& command, std::size_t i, const Bars& bars) {
  const double position = command.position[i];
  const double speed = command.speed_limit[i];
  if (!std::isfinite(position) || !within(position, bars.joint_min, bars.joint_max, i, bars.rounding)) {
    return text("joint %zu to %.4f rad, outside its limits", i, position);
  }
  if (i < bars.joint_speed.size() && !(speed > 0.0 && speed <= bars.joint_speed[i] + bars.rounding)) {
    return text("joint %zu at %.4f rad/s, its limit is %.4f", i, speed, bars.joint_speed[i]);
  }
  return {};
}

// What a process that hung says as it goes on answers what was measured before, and no mover obeys it: where the shafts
// are by then says nothing of it.
bool too_old_to_be_obeyed(const Timeline& timeline, const Heard<JointCommand>& command, const Bars& bars) {
  const auto& truth = timeline.base_truth;
  const auto after = std::upper_bound(truth.begin(), truth.end(), command.t,
                                      [](std::int64_t t, const auto& heard) { return t < heard.t; });
  if (after == truth.begin()) return false;
  return seconds_between(command.message.utime, std::prev(after)->message.utime) > bars.command_age + bars.truth_period;
}

// Whoever commanded it, the arm stays within its joints' limits, and no joint is faster than it may be.
void judge_true_arm(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const std::size_t joints = bars.joint_speed.size();
  for (const ArmStep& step : arm_steps(timeline)) {
    const std::vector<double>& from = step.from->message.shaft;
    const std::vector<double>& to = step.to->message.shaft;
    if (from.size() != joints || to.size() != joints) continue;
    ++verdict.judged;
    // By the stamps, which are exact; the world's own seconds where the clock was set between them.
    const double told = seconds_between(step.from->message.utime, step.to->message.utime);
    const double passed = step.to->world - step.from->world;
    const double seconds = std::max({told > 0.0 && told < 1.0 ? told : passed, bars.truth_period});
    for (std::size_t i = 0; i < joints; ++i) {
      if (!within(to[i], bars.joint_min, bars.joint_max, i, bars.shaft_slack)) {
        note(verdict, step.to->t,
             text("joint %zu is at %.4f rad at %.2f s (world), outside its limits", i, to[i], step.to->world));
      }
      const double speed = std::abs(to[i] - from[i]) / seconds;
      if (speed <= bars.joint_speed[i] * bars.speed_share + bars.shaft_slack / seconds) continue;
      note(verdict, step.to->t,
           text("joint %zu leaps: %.4f rad in %.3f s by %.2f s (world); its limit is %.3f rad/s", i,
                std::abs(to[i] - from[i]), seconds, step.to->world, bars.joint_speed[i]));
    }
  }
}

// Likewise the base.
void judge_true_base(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  for (const auto& truth : timeline.base_truth) {
    ++verdict.judged;
    if (std::abs(truth.message.speed) <= bars.base_speed * bars.speed_share &&
        std::abs(truth.message.turn_rate) <= bars.base_turn_rate * bars.speed_share)
      continue;
    note(verdict, truth.t,
         text("the base moves at %.3f m/s and %.3f rad/s at %.2f s (world); allowed: %.3f and %.3f",
              truth.message.speed, truth.message.turn_rate, truth.world, bars.base_speed, bars.base_turn_rate));
  }
}

// One reset, as often as it was heard.
struct Reset {
  bool heard = false;
  double age = 1e18;  // s, the least
};

}  // namespace

Verdict commands_are_within_limits(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  const ShaftsAround shafts(timeline);
  for (const auto& heard : timeline.joint_commands) {
    const JointCommand& command = heard.message;
    if (heard.foreign || !timeline.is("visual-servo", command.session)) continue;
    ++verdict.judged;
    const bool too_old = too_old_to_be_obeyed(timeline, heard, bars);
    for (std::size_t i = 0; i < command.position.size() && i < command.speed_limit.size(); ++i) {
      if (const std::string wrong = wrong_joint(command, i, bars); !wrong.empty()) note(verdict, heard.t, wrong);
      double lead = 0.0;
      if (too_old || !shafts.distance(heard.t, i, command.position[i], lead)) continue;
      const double allowed = bars.lead_time * command.speed_limit[i] + bars.lead_rad;
      if (lead <= allowed + bars.rounding) continue;
      note(verdict, heard.t,
           text("joint %zu is commanded %.3f rad away from where it is at %.2f s (world); allowed: %.3f", i, lead,
                heard.world, allowed));
    }
  }
  for (const auto& heard : timeline.base_commands) {
    const BaseCommand& command = heard.message;
    if (heard.foreign || !timeline.is("base-navigator", command.session)) continue;
    ++verdict.judged;
    if (!(std::abs(command.speed) <= bars.base_speed + bars.rounding) ||
        !(std::abs(command.turn_rate) <= bars.base_turn_rate + bars.rounding)) {
      note(verdict, heard.t,
           text("the base at %.3f m/s and %.3f rad/s; allowed: %.3f and %.3f", command.speed, command.turn_rate,
                bars.base_speed, bars.base_turn_rate));
    }
  }
  judge_true_arm(timeline, bars, verdict);
  judge_true_base(timeline, bars, verdict);
  return verdict;
}

Verdict release_needs_a_fresh_reset(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  std::map<std::pair<std::string, std::int64_t>, bool> latched;  // by device and session
  for (const auto& heard : timeline.stop_states) {
    const StopState& state = heard.message;
    if (heard.foreign || !timeline.is("simulator", state.session)) continue;
    auto [known, first] = latched.try_emplace({state.device, state.session}, true);  // movers come up latched
    const bool released = known->second && !state.latched;
    known->second = state.latched;
    if (!released) continue;
    ++verdict.judged;
    Reset reset;
    for (const auto& request : timeline.stops) {
      const StopRequest& asked = request.message;
      if (request.t > heard.t + 100'000) break;
      if (asked.kind != StopRequest::RESET || asked.session != state.request_session ||
          asked.request_id != state.request_id)
        continue;
      reset.heard = true;
      reset.age = std::min(reset.age, std::abs(seconds_between(asked.utime, state.utime)));
    }
    const double lost = timeline.loses_messages(heard.t) ? bars.state_period : 0.0;
    if (reset.heard && reset.age <= bars.reset_age + bars.reset_rounding + lost) continue;
    note(verdict, heard.t,
         text("%s released at %.2f s (world) by %s", state.device.c_str(), heard.world,
              reset.heard ? text("a reset %.1f s old", reset.age).c_str() : "no reset that was heard"));
  }
  return verdict;
}

}  // namespace markservo::campaign
