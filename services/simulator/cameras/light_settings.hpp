#pragma once

// Settings `light.*`: how bright and of which colour the pictures are.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct LightSettings {
  double gain = 1.0;
  double cast_red = 1.0;
  double cast_green = 1.0;
  double cast_blue = 1.0;
  double vary = 1.0;
};

inline constexpr Setting<LightSettings> kLightSettings[] = {
    {"light.gain", &LightSettings::gain, 0.0, 4.0, TakesEffect::kAtOnce, "factor on every pixel"},
    {"light.cast_red", &LightSettings::cast_red, 0.0, 4.0, TakesEffect::kAtOnce, "factor on the red channel"},
    {"light.cast_green", &LightSettings::cast_green, 0.0, 4.0, TakesEffect::kAtOnce, "factor on the green channel"},
    {"light.cast_blue", &LightSettings::cast_blue, 0.0, 4.0, TakesEffect::kAtOnce, "factor on the blue channel"},
    {"light.vary", &LightSettings::vary, 0.0, 1.0, TakesEffect::kAtReset,
     "how much the seed varies the lamps, 0: not at all"},
};

}  // namespace markservo::simulator
