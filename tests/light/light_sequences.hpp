#pragma once

// How light changes over a sequence of frames, by kind: gains of the channels.

#include <array>
#include <string>
#include <vector>

namespace markservo::light {

inline constexpr double kLeastGain = 0.4;
inline constexpr double kGreatestGain = 2.5;
inline constexpr double kCast = 0.15;  // either way, of each channel

using Gains = std::array<double, 3>;  // of blue, green and red; 1 is the light the robot's file was written in

// The kinds, for tables: "steps", "lamp", "dusk", "saturation", "corners", "flicker", "hidden".
const std::vector<std::string>& light_kinds();

struct LightFrame {
  Gains gains{1.0, 1.0, 1.0};
  bool marks_hidden = false;  // something stands before all marks
};

// `num_frames` frames of a kind, all beginning with a few frames of gain 1:
//   steps       every 12 frames another gain (0.4 to 2.5) and cast (15% either way) at once
//   lamp        a warm lamp of twice the light on and off every 15 frames
//   dusk        a slow ramp down to 0.4, turning blue or red, and up again
//   saturation  2.5 times the light with a random cast, on and off every 12 frames
//   corners     every 12 frames another cast at its limits in every channel, and gain 0.4, 1 or 2.5
//   flicker     between two such lights every other frame
//   hidden      like steps, but the light changes while the marks are hidden for 40 frames
// Throws std::invalid_argument for another kind.
std::vector<LightFrame> light_sequence(const std::string& kind, int num_frames, unsigned seed);

}  // namespace markservo::light
