#pragma once

#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <string>

namespace markservo::experiments {

// Writes the frame's left and right image side by side as a PNG, with the boxes, the matched points and the measured
// positions of the marks. Messages that answer another frame are left out.
void write_annotated_picture(const std::string& path, const StereoFrame& frame, const MarkDetection& detection,
                             const StereoMatches& matches, const TargetPose& pose, const std::string& title);

}  // namespace markservo::experiments
