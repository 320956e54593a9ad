#pragma once

// Settings `calibration.*`: how far the calibration is off, of the cameras themselves and of the arm against them.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct CalibrationSettings {
  double f_scale = 1.0;
  double b_scale = 1.0;
  double arm_x = 0.0;
  double arm_y = 0.0;
  double arm_z = 0.0;
  double arm_yaw_deg = 0.0;
};

inline constexpr Setting<CalibrationSettings> kCalibrationSettings[] = {
    {"calibration.f_scale", &CalibrationSettings::f_scale, 0.5, 2.0, TakesEffect::kAtOnce,
     "reported focal length over the true one"},
    {"calibration.b_scale", &CalibrationSettings::b_scale, 0.5, 2.0, TakesEffect::kAtOnce,
     "reported baseline over the true one"},
    {"calibration.arm_x", &CalibrationSettings::arm_x, -0.1, 0.1, TakesEffect::kAtReset,
     "m, true arm base minus robot.yaml's"},
    {"calibration.arm_y", &CalibrationSettings::arm_y, -0.1, 0.1, TakesEffect::kAtReset, "m, likewise"},
    {"calibration.arm_z", &CalibrationSettings::arm_z, -0.1, 0.1, TakesEffect::kAtReset, "m, likewise"},
    {"calibration.arm_yaw_deg", &CalibrationSettings::arm_yaw_deg, -20.0, 20.0, TakesEffect::kAtReset, "deg, likewise"},
};

}  // namespace markservo::simulator
