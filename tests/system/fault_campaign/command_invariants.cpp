// I5 and I6: what may be commanded, and what releases.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// Where the shafts were around a moment: at the last stamp before it, and at the next.
class ShaftsAround {
 public:
  explicit ShaftsAround(const Timeline& timeline) : truth_(timeline.truth) {}

  // How far `angle` of joint `i` is from where that joint was around `t`, rad; false where nothing is known.
  bool distance(std::int64_t t, std::size_t i, double angle, double& distance) const {
    const auto after = std::upper_bound(truth_.begin(), truth_.end(), t,
                                        [](std::int64_t time, const auto& truth) { return time < truth.t; });
    if (after == truth_.begin() || after == truth_.end()) return false;
    const SimTruth& last = std::prev(after)->message;
    const SimTruth& next = after->message;
    if (!same_world(last, next) || i >= last.shaft.size() || i >= next.shaft.size()) return false;
    const double low = std::min(last.shaft[i], next.shaft[i]);
    const double high = std::max(last.shaft[i], next.shaft[i]);
    distance = angle < low ? low - angle : angle > high ? angle - high : 0.0;
    return true;
  }

 private:
  const Stream<SimTruth>& truth_;
};

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
    for (std::size_t i = 0; i < command.position.size() && i < command.speed_limit.size(); ++i) {
      if (const std::string wrong = wrong_joint(command, i, bars); !wrong.empty()) note(verdict, heard.t, wrong);
      double lead = 0.0;
      if (!shafts.distance(heard.t, i, command.position[i], lead)) continue;
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
    if (reset.heard && reset.age <= bars.reset_age + bars.reset_slack) continue;
    note(verdict, heard.t,
         text("%s released at %.2f s (world) by %s", state.device.c_str(), heard.world,
              reset.heard ? text("a reset %.1f s old", reset.age).c_str() : "no reset that was heard"));
  }
  return verdict;
}

}  // namespace markservo::campaign
