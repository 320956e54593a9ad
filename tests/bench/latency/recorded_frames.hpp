#pragma once

// A few seconds of a camera's STEREO_FRAME messages, in memory.

#include <markservo/StereoFrame.hpp>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::bench {

enum class Encoding { kRaw, kJpeg };

// One message a pair; utime, session and seq are the sender's to fill.
std::vector<StereoFrame> record_frames(const std::vector<scenes::StereoPair>& pairs,
                                       const geometry::StereoCamera& camera, Encoding encoding);

}  // namespace markservo::bench
