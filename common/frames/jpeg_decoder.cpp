#include "common/frames/jpeg_decoder.hpp"

#include <turbojpeg.h>

#include <new>
#include <opencv2/imgcodecs.hpp>

namespace markservo::frames {
namespace {

// By OpenCV, without the orientation that EXIF states; empty if it cannot or finds another size.
cv::Mat decode_raw(const std::vector<std::uint8_t>& bytes, cv::Size size) {
  try {
    const cv::Mat picture = cv::imdecode(bytes, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
    return picture.size() == size ? picture : cv::Mat();
  } catch (const cv::Exception&) {
    return {};
  }
}

}  // namespace

void JpegDecoder::Release::operator()(void* decompressor) const {
  tjDestroy(decompressor);
}

JpegDecoder::JpegDecoder() : decompressor_(tjInitDecompress()) {
  if (!decompressor_) throw std::bad_alloc();
}

cv::Mat JpegDecoder::unpack(const std::vector<std::uint8_t>& bytes, cv::Size size) {
  int subsampling = 0;
  int colours = 0;
  cv::Size stated;
  if (bytes.empty() || tjDecompressHeader3(decompressor_.get(), bytes.data(), bytes.size(), &stated.width,
                                           &stated.height, &subsampling, &colours) != 0) {
    return {};
  }
  if (stated != size) return {};
  // Colours of print, which this interface does not turn into BGR.
  if (colours == TJCS_CMYK || colours == TJCS_YCCK) return decode_raw(bytes, size);
  picture_.create(size, CV_8UC3);
  Outcome outcome = decompress(bytes);
  if (outcome == Outcome::kDamaged) {
    // What it did not reach still shows the picture before.
    picture_.setTo(cv::Scalar());
    outcome = decompress(bytes);
  }
  return outcome == Outcome::kUnreadable ? cv::Mat() : picture_;
}

JpegDecoder::Outcome JpegDecoder::decompress(const std::vector<std::uint8_t>& bytes) {
  const int status = tjDecompress2(decompressor_.get(), bytes.data(), bytes.size(), picture_.data, picture_.cols,
                                   static_cast<int>(picture_.step[0]), picture_.rows, TJPF_BGR, TJFLAG_LIMITSCANS);
  if (status == 0) return Outcome::kWhole;
  return tjGetErrorCode(decompressor_.get()) == TJERR_WARNING ? Outcome::kDamaged : Outcome::kUnreadable;
}

}  // namespace markservo::frames
