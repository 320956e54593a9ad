#include "tests/bench/latency/recorded_frames.hpp"

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

namespace markservo::bench {
namespace {

constexpr int kJpegQuality = 90;  // as stereo-camera sends them

std::vector<std::uint8_t> bytes_of(const cv::Mat& image, Encoding encoding) {
  if (encoding == Encoding::kRaw) return {image.datastart, image.dataend};
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality})) {
    throw std::runtime_error("record_frames: OpenCV could not encode the picture");
  }
  return bytes;
}

}  // namespace

std::vector<StereoFrame> record_frames(const std::vector<scenes::StereoPair>& pairs,
                                       const geometry::StereoCamera& camera, Encoding encoding) {
  std::vector<StereoFrame> frames;
  frames.reserve(pairs.size());
  for (const scenes::StereoPair& pair : pairs) {
    StereoFrame frame{};
    frame.calibration.fx = camera.fx;
    frame.calibration.fy = camera.fy;
    frame.calibration.cx_left = camera.cx_left;
    frame.calibration.cx_right = camera.cx_right;
    frame.calibration.cy = camera.cy;
    frame.calibration.baseline = camera.baseline;
    frame.width = pair.left.cols;
    frame.height = pair.left.rows;
    frame.encoding = encoding == Encoding::kRaw ? StereoFrame::ENCODING_BGR8 : StereoFrame::ENCODING_JPEG;
    frame.left = bytes_of(pair.left, encoding);
    frame.right = bytes_of(pair.right, encoding);
    frame.left_size = static_cast<std::int32_t>(frame.left.size());
    frame.right_size = static_cast<std::int32_t>(frame.right.size());
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace markservo::bench
