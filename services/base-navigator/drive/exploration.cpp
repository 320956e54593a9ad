#include "services/base-navigator/drive/exploration.hpp"

namespace markservo::base_navigator {

std::optional<Advice> Exploration::step(const ExploreParameters& parameters, double heading_sigma,
                                        const PathGuard& guard, const Situation& situation, double clearance) {
  if (situation.heading_sigma <= (active_ ? parameters.heading_known : heading_sigma)) {
    active_ = false;
    failed_ = false;
    return std::nullopt;
  }
  if (!active_ || epoch_ != situation.epoch) begin(parameters, guard, situation, clearance);
  const double gone = (X_OR_start_.inverse() * situation.X_OR).distance();
  if (gone >= parameters.distance) {
    failed_ = true;
    active_ = false;
    return Advice{brake(), DriveState::kLost, "the heading did not become known"};
  }
  Advice advice = advice_of(guard.straight(situation, clearance, direction_, parameters.speed, passage_));
  if (advice.reason.empty()) advice.reason = "learning the heading";
  return advice;
}

void Exploration::begin(const ExploreParameters& parameters, const PathGuard& guard, const Situation& situation,
                        double clearance) {
  active_ = true;
  epoch_ = situation.epoch;
  X_OR_start_ = situation.X_OR;
  passage_ = PassageState();
  const double ahead = guard.straight_room(situation, clearance, Direction::kForward, parameters.distance);
  const double behind = guard.straight_room(situation, clearance, Direction::kBackward, parameters.distance);
  const bool back = ahead < parameters.room_ahead && behind > ahead;
  direction_ = back ? Direction::kBackward : Direction::kForward;
}

}  // namespace markservo::base_navigator
