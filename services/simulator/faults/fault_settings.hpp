#pragma once

// Settings `faults.*`: sensors that say what is not so.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct FaultSettings {
  double frozen_joint = 0.0;
  double frozen_camera = 0.0;
  double stuck_encoder = 0.0;
  double reversed_encoder = 0.0;
};

inline constexpr Setting<FaultSettings> kFaultSettings[] = {
    {"faults.frozen_joint", &FaultSettings::frozen_joint, 0.0, 3.0, TakesEffect::kAtOnce,
     "JOINT_STATE tells of this joint (1 to 3) where it stood when this was set; 0: none", true},
    {"faults.frozen_camera", &FaultSettings::frozen_camera, 0.0, 1.0, TakesEffect::kAtOnce,
     "1: the cameras show what they saw when this was set", true},
    {"faults.stuck_encoder", &FaultSettings::stuck_encoder, 0.0, 2.0, TakesEffect::kAtOnce,
     "the encoder of this wheel (1 left, 2 right) does not count; 0: none", true},
    {"faults.reversed_encoder", &FaultSettings::reversed_encoder, 0.0, 2.0, TakesEffect::kAtOnce,
     "the encoder of this wheel (1 left, 2 right) counts backwards; 0: none", true},
};

}  // namespace markservo::simulator
