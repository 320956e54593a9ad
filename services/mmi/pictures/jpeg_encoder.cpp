#include "services/mmi/pictures/jpeg_encoder.hpp"

#include <turbojpeg.h>

#include <stdexcept>

namespace markservo::mmi {

JpegEncoder::JpegEncoder() : compressor_(tjInitCompress()) {
  if (compressor_ == nullptr) throw std::runtime_error(std::string("no JPEG encoder: ") + tjGetErrorStr());
}

JpegEncoder::~JpegEncoder() {
  tjFree(buffer_);
  tjDestroy(compressor_);
}

std::string JpegEncoder::encode(const std::uint8_t* bgr, int width, int height) {
  if (tjCompress2(compressor_, bgr, width, 0, height, TJPF_BGR, &buffer_, &size_, TJSAMP_420, kQuality, 0) != 0) {
    throw std::runtime_error(std::string("a picture cannot be made a JPEG: ") + tjGetErrorStr2(compressor_));
  }
  return std::string(reinterpret_cast<const char*>(buffer_), size_);
}

}  // namespace markservo::mmi
