#include "services/simulator/base/base_drive.hpp"

#include <algorithm>

namespace markservo::simulator {
namespace {

double approach(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

void BaseDrive::command(const BaseMotion& wanted) {
  wanted_.speed = std::clamp(wanted.speed, -base_.speed_max, base_.speed_max);
  wanted_.turn_rate = std::clamp(wanted.turn_rate, -base_.turn_rate_max, base_.turn_rate_max);
}

BaseDrive::Travel BaseDrive::step(double dt) {
  const BaseMotion old = motion_;
  motion_.speed = approach(old.speed, wanted_.speed, base_.acceleration_max * dt);
  motion_.turn_rate = approach(old.turn_rate, wanted_.turn_rate, base_.turn_acceleration_max * dt);
  return {0.5 * (old.speed + motion_.speed) * dt, 0.5 * (old.turn_rate + motion_.turn_rate) * dt};
}

}  // namespace markservo::simulator
