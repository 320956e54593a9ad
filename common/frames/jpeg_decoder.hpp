#pragma once

// Unpacks one camera's JPEG pictures, one after the other into the same memory: libjpeg-turbo by its own interface
// takes a quarter of cv::imdecode's time for the same pixels.

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <vector>

namespace markservo::frames {

class JpegDecoder {
 public:
  JpegDecoder();

  // The picture as 8-bit BGR, as the sensor saw it (no orientation that its EXIF states is applied); until the next
  // call. Empty if the bytes are no JPEG that can be read, or one of another size than `size`. What a damaged or short
  // file does not tell is black.
  cv::Mat unpack(const std::vector<std::uint8_t>& bytes, cv::Size size);

 private:
  struct Release {
    void operator()(void* decompressor) const;
  };
  enum class Outcome { kWhole, kDamaged, kUnreadable };
  Outcome decompress(const std::vector<std::uint8_t>& bytes);

  std::unique_ptr<void, Release> decompressor_;
  cv::Mat picture_;
};

}  // namespace markservo::frames
