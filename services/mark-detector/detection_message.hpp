#pragma once

#include <markservo/channels.hpp>

#include "services/mark-detector/detector_output.hpp"

namespace markservo::mark_detector {

// The answer to `frame`; session and seq are the publisher's to fill.
MarkDetection make_message(const StereoFrame& frame, const Output& output);

}  // namespace markservo::mark_detector
