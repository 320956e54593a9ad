#pragma once

// Settings `frames.*`: how many pictures there are, and how many are lost.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct FramesSettings {
  double rate_hz = 15.0;  // what two busy cores render in real time
  double drop_rate = 0.0;
};

inline constexpr Setting<FramesSettings> kFramesSettings[] = {
    {"frames.rate_hz", &FramesSettings::rate_hz, 4.0, 100.0, TakesEffect::kAtOnce, "Hz"},
    {"frames.drop_rate", &FramesSettings::drop_rate, 0.0, 1.0, TakesEffect::kAtOnce, "share of frames that are lost"},
};

// In lockstep, which waits for whatever takes long, a real camera's 30 frames a second.
inline FramesSettings default_frames_settings(bool lockstep) {
  FramesSettings settings;
  if (lockstep) settings.rate_hz = 30.0;
  return settings;
}

}  // namespace markservo::simulator
