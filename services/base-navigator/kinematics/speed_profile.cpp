#include "services/base-navigator/kinematics/speed_profile.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::base_navigator {

double stopping_speed(double distance, double braking, double reaction) {
  if (distance <= 0.0) return 0.0;
  return braking * (std::sqrt(reaction * reaction + 2.0 * distance / braking) - reaction);
}

double stopping_distance(double speed, double braking, double reaction) {
  const double v = std::abs(speed);
  return v * reaction + v * v / (2.0 * braking);
}

double ramped(double from, double target, double acceleration, double braking, double seconds) {
  const bool turns_round = from * target < 0.0;
  const double aim = turns_round ? 0.0 : target;
  const double rate = std::abs(aim) < std::abs(from) ? braking : acceleration;
  return from + std::clamp(aim - from, -rate * seconds, rate * seconds);
}

}  // namespace markservo::base_navigator
