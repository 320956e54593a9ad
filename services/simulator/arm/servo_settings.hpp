#pragma once

// Settings `servo.*`: what the arm's servos make of their commands, and when.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct ServoSettings {
  double speed_deg_s = 0.0;
  double acceleration_deg_s2 = 5730.0;  // 100 rad/s2: 1 N m on the 0.01 kg m2 of a small arm
  double deadband_deg = 0.3;
  double deadband_kind = 0.0;
  double backlash_deg = 0.0;
  double delay_frames = 1.0;
  double delay_s = 0.0;
};

inline constexpr Setting<ServoSettings> kServoSettings[] = {
    {"servo.speed_deg_s", &ServoSettings::speed_deg_s, 0.0, 2000.0, TakesEffect::kAtOnce,
     "deg/s, fastest joint speed; 0: each joint's own in robot.yaml"},
    {"servo.acceleration_deg_s2", &ServoSettings::acceleration_deg_s2, 500.0, 1e6, TakesEffect::kAtOnce,
     "deg/s2, how fast a motor gathers speed and brakes"},
    {"servo.deadband_deg", &ServoSettings::deadband_deg, 0.0, 5.0, TakesEffect::kAtOnce,
     "deg, half-width around the commanded angle"},
    {"servo.deadband_kind", &ServoSettings::deadband_kind, 0.0, 1.0, TakesEffect::kAtOnce,
     "0: the servo stops at the deadband's edge; 1: once started it runs home", true},
    {"servo.backlash_deg", &ServoSettings::backlash_deg, 0.0, 5.0, TakesEffect::kAtOnce,
     "deg, play between motor and joint"},
    {"servo.delay_frames", &ServoSettings::delay_frames, 0.0, 30.0, TakesEffect::kAtOnce,
     "lockstep: the answer to frame k takes effect at the exposure of frame k + this", true},
    {"servo.delay_s", &ServoSettings::delay_s, 0.0, 1.0, TakesEffect::kAtOnce,
     "s, real time: from a command's arrival to its effect"},
};

}  // namespace markservo::simulator
