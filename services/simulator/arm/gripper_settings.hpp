#pragma once

// Settings `gripper.*`: how its fingers hold and move.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct GripperSettings {
  double friction = 1.2;
  double speed = 0.1;
};

inline constexpr Setting<GripperSettings> kGripperSettings[] = {
    {"gripper.friction", &GripperSettings::friction, 0.05, 3.0, TakesEffect::kAtReset, "fingers on anything"},
    {"gripper.speed", &GripperSettings::speed, 0.005, 1.0, TakesEffect::kAtOnce, "m/s, change of the opening"},
};

}  // namespace markservo::simulator
