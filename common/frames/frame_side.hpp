#pragma once

// The pictures of a STEREO_FRAME, however they are packed.

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "common/frames/jpeg_decoder.hpp"

namespace markservo::frames {

// One side of a frame, `side`, as 8-bit BGR of the frame's size. A raw one is not copied and must outlive the picture,
// as the decoder must that of a JPEG. Throws std::runtime_error with a line in which the side goes by `name`, where it
// is no JPEG of that size.
cv::Mat picture_of(const StereoFrame& frame, const std::vector<std::uint8_t>& side, const std::string& name,
                   JpegDecoder& decoder);

}  // namespace markservo::frames
