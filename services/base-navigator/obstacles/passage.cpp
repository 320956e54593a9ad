#include "services/base-navigator/obstacles/passage.hpp"

#include <fmt/format.h>

#include "services/base-navigator/kinematics/speed_profile.hpp"
#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {
namespace {

void watch(const PassageParameters& parameters, const FreePath& free, std::int64_t utime, PassageState& state) {
  if (!state.blocked) {
    state.blocked = free.limited && free.length < parameters.blocked_below;
    state.free_since = 0;
    return;
  }
  if (free.limited && free.length < parameters.free_above) {
    state.free_since = 0;
  } else if (state.free_since == 0) {
    state.free_since = utime;
  } else if (seconds_between(state.free_since, utime) >= parameters.free_for) {
    state.blocked = false;
  }
}

}  // namespace

Passage pass(const PassageParameters& parameters, double braking, const FreePath& free, double clearance,
             double path_speed, const Motion& desired, std::int64_t utime, PassageState& state) {
  watch(parameters, free, utime, state);
  Passage passage;
  passage.motion = desired;
  passage.blocked = state.blocked;
  if (!free.limited && !state.blocked) return passage;
  const double allowed = state.blocked ? 0.0 : stopping_speed(free.length, braking, parameters.reaction);
  if (allowed < path_speed) {
    passage.motion.speed *= allowed / path_speed;
    passage.motion.turn_rate *= allowed / path_speed;
    passage.motion.brake = true;
  }
  if (!state.blocked) return passage;
  passage.reason = free.limited ? fmt::format("something {:.2f} m {} of the robot; it keeps {:.2f} m", free.distance,
                                              side_of(free.bearing), clearance)
                                : fmt::format("the way is free; waiting {:.1f} s", parameters.free_for);
  return passage;
}

}  // namespace markservo::base_navigator
