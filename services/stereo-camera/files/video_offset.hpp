#pragma once

// The offset between two videos' clocks, from their first minute.

#include "services/stereo-camera/files/image_stream.hpp"
#include "services/stereo-camera/files/offset_estimate.hpp"

namespace markservo::stereo_camera {

// Reads up to the first minute of both, from where they are, and rewinds them. Throws ConfigurationError, which says
// what was found and what to do, where the videos do not tell their offset.
OffsetEstimate measure_offset(ImageStream& left, ImageStream& right);

}  // namespace markservo::stereo_camera
