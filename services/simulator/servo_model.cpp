#include "services/simulator/servo_model.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::simulator {
namespace {

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

void ServoModel::advance(const ServoParameters& parameters, double dt) {
  const double old_ramp = ramp_;
  ramp_ = approach(ramp_, target_, std::min(speed_limit_, parameters.speed) * dt);
  ramp_speed_ = (ramp_ - old_ramp) / dt;

  const bool outside = std::abs(ramp_ - motor_) > parameters.deadband;
  const double step = parameters.speed * dt;
  switch (parameters.deadband_kind) {
    case DeadbandKind::kStopsAtEdge:
      running_home_ = false;
      if (outside) {
        const double edge = ramp_ - std::copysign(parameters.deadband, ramp_ - motor_);
        motor_ = approach(motor_, edge, step);
      }
      break;
    case DeadbandKind::kRunsHome:
      running_home_ = running_home_ || outside;
      if (running_home_) {
        motor_ = approach(motor_, ramp_, step);
        running_home_ = motor_ != ramp_;
      }
      break;
  }

  const double old_shaft = shaft_;
  const double play = 0.5 * parameters.backlash;
  shaft_ = std::clamp(shaft_, motor_ - play, motor_ + play);
  shaft_speed_ = (shaft_ - old_shaft) / dt;
}

}  // namespace markservo::simulator
