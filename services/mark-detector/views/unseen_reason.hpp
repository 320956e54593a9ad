#pragma once

#include <cstdint>
#include <string>

#include "services/mark-detector/detector_output.hpp"

namespace markservo::mark_detector {

// Why blobs of the mark's colour are missing in one or both images, by what was found there. `single`: there is no
// right image.
std::string why_unseen(const Finding& finding, std::int64_t min_area, bool single);

}  // namespace markservo::mark_detector
