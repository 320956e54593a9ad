#include "services/base-navigator/kinematics/motion.hpp"

#include <algorithm>
#include <cmath>

#include "services/base-navigator/kinematics/speed_profile.hpp"

namespace markservo::base_navigator {

Command next_command(const MotionParameters& parameters, const Motion& motion, const Command& previous,
                     const Command& measured, double seconds) {
  const double lead = parameters.command_lead * parameters.braking;
  const double turn_lead = parameters.command_lead * parameters.turn_braking;
  const double speed = std::clamp(previous.speed, measured.speed - lead, measured.speed + lead);
  const double turn_rate =
      std::clamp(previous.turn_rate, measured.turn_rate - turn_lead, measured.turn_rate + turn_lead);
  const double braking = motion.brake ? parameters.braking : parameters.acceleration;
  const double turn_braking = motion.brake ? parameters.turn_braking : parameters.turn_acceleration;
  Command command;
  command.speed = ramped(speed, motion.speed, parameters.acceleration, braking, seconds);
  const double wanted = motion.turn_rate + motion.curvature * std::abs(command.speed);
  command.turn_rate = ramped(turn_rate, std::clamp(wanted, -parameters.turn_rate, parameters.turn_rate),
                             parameters.turn_acceleration, turn_braking, seconds);
  return command;
}

}  // namespace markservo::base_navigator
