#include "services/base-navigator/drive/turning.hpp"

#include <algorithm>
#include <cmath>

#include "services/base-navigator/kinematics/speed_profile.hpp"

namespace markservo::base_navigator {
namespace {

constexpr double kFast = 3.0;  // times creeping: going away from an obstacle needs less care than going to the goal

}  // namespace

GuardedTurn turn_on_spot(const PathGuard& guard, const Situation& situation, double clearance, double angle,
                         PassageState& passage) {
  const MotionParameters& motion = guard.motion();
  if (std::abs(situation.measured.speed) > motion.rolling) return {};
  const double rate = std::clamp(stopping_speed(std::abs(angle), motion.turn_acceleration, motion.goal_reaction),
                                 motion.turn_creep, motion.turn_rate);
  return guard.turn(situation, clearance, angle, rate, passage);
}

std::optional<Advice> TurningRoom::step(const TurnParameters& parameters, const PathGuard& guard,
                                        const Situation& situation, double clearance, const GuardedTurn& turn,
                                        int corrections) {
  if (!turn.free.limited) return std::nullopt;
  const Direction away = std::abs(turn.free.bearing) < M_PI / 2.0 ? Direction::kBackward : Direction::kForward;
  const double budget = parameters.room_max * (1 + corrections) - made_;
  const double room = guard.straight_room(situation, clearance, away, parameters.room_step);
  if (budget <= 0.0 || room <= guard.passage().free_above) return std::nullopt;
  counted_ = Counted{situation.X_OR, situation.epoch};
  PassageState passage;
  return advice_of(guard.straight(situation, clearance, away, kFast * guard.motion().creep, passage));
}

void TurningRoom::count(const Situation& situation, bool turning) {
  if (!counted_) return;
  if (!turning) {
    counted_.reset();
    return;
  }
  if (counted_->epoch == situation.epoch) made_ += (counted_->X_OR.inverse() * situation.X_OR).distance();
  counted_ = Counted{situation.X_OR, situation.epoch};
}

}  // namespace markservo::base_navigator
