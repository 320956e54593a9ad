#include "services/simulator/arm/servo_model.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::simulator {
namespace {

constexpr double kArrived = 1e-9;  // rad

// From `from` towards `to` by at most `step`; exactly `to` when that is near enough.
double approach(double from, double to, double step) {
  if (std::abs(to - from) <= step) return to;
  return from + std::copysign(step, to - from);
}

}  // namespace

void ServoModel::command(double target, double speed_limit) {
  target_ = target;
  speed_limit_ = speed_limit;
}

// As fast as the motor can and still stop at the goal.
void ServoModel::drive_motor(const ServoParameters& parameters, double goal, double dt) {
  const double way = goal - motor_;
  const double change = parameters.acceleration * dt;
  // After this step the rest of the way still suffices for braking: v dt + v^2 / (2 a) = |way|.
  const double stoppable = std::sqrt(change * change + 2.0 * parameters.acceleration * std::abs(way)) - change;
  const double wanted = std::copysign(std::min(stoppable, parameters.speed), way);
  motor_speed_ = approach(motor_speed_, wanted, change);
  if (std::abs(way - motor_speed_ * dt) <= kArrived && std::abs(motor_speed_) <= change) {
    motor_ = goal;
    motor_speed_ = 0.0;
    return;
  }
  motor_ += motor_speed_ * dt;
}

void ServoModel::step(const ServoParameters& parameters, double dt) {
  const double old_ramp = ramp_;
  ramp_ = approach(ramp_, target_, std::min(speed_limit_, parameters.speed) * dt);
  ramp_speed_ = (ramp_ - old_ramp) / dt;

  const bool outside = std::abs(ramp_ - motor_) > parameters.deadband;
  double goal = motor_;
  switch (parameters.deadband_kind) {
    case DeadbandKind::kStopsAtEdge:
      running_home_ = false;
      if (outside) goal = ramp_ - std::copysign(parameters.deadband, ramp_ - motor_);
      break;
    case DeadbandKind::kRunsHome:
      running_home_ = running_home_ || outside;
      if (running_home_) goal = ramp_;
      break;
  }
  drive_motor(parameters, goal, dt);
  running_home_ = running_home_ && motor_ != ramp_;

  const double old_shaft = shaft_;
  const double play = 0.5 * parameters.backlash;
  shaft_ = std::clamp(shaft_, motor_ - play, motor_ + play);
  shaft_speed_ = (shaft_ - old_shaft) / dt;
}

}  // namespace markservo::simulator
