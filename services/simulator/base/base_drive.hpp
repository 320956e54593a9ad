#pragma once

#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

struct BaseMotion {
  double speed = 0.0;      // m/s, forward
  double turn_rate = 0.0;  // rad/s, counter-clockwise
};

// The motors' controller: turns the wheels as commanded, within the description's limits, as the encoders measure it.
class BaseDrive {
 public:
  explicit BaseDrive(const robot::BaseDescription& base) : base_(base) {}

  // Finite; cut to the limits of speed, and approached with those of acceleration.
  void command(const BaseMotion& wanted);

  // How far the wheels' middle went and turned meanwhile, had they no slip.
  struct Travel {
    double way = 0.0;   // m
    double turn = 0.0;  // rad
  };
  // Lets `dt` (s, above 0) pass.
  Travel step(double dt);

 private:
  robot::BaseDescription base_;
  BaseMotion wanted_;
  BaseMotion motion_;
};

}  // namespace markservo::simulator
