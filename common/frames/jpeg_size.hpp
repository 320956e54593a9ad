#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace markservo::frames {

struct JpegSize {
  int width = 0;   // px, 1 to 65535
  int height = 0;  // px, 1 to 65535
};

// The size that a JPEG file's frame header (SOF, ITU-T T.81 B.2.2) states, read without decoding anything: a file of a
// few bytes can claim gigabytes of pixels. Nothing if the bytes do not begin as a JPEG, end before the frame header,
// hold anything but marker segments before it, or state no size.
std::optional<JpegSize> jpeg_size(const std::vector<std::uint8_t>& bytes);

}  // namespace markservo::frames
