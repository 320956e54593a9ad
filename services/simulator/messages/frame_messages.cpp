#include "services/simulator/messages/frame_messages.hpp"

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace markservo::simulator {
namespace {

std::vector<std::uint8_t> encoded(const cv::Mat& image, int jpeg_quality) {
  if (jpeg_quality == 0) return {image.datastart, image.dataend};
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, jpeg_quality});
  return bytes;
}

}  // namespace

StereoFrame frame_message(const robot::CameraDescription& cameras, const CalibrationSettings& settings,
                          const ImagePair& images, int jpeg_quality) {
  StereoFrame message{};
  message.calibration.fx = cameras.stereo.fx * settings.f_scale;
  message.calibration.fy = cameras.stereo.fy * settings.f_scale;
  message.calibration.cx_left = cameras.stereo.cx_left;
  message.calibration.cx_right = cameras.stereo.cx_right;
  message.calibration.cy = cameras.stereo.cy;
  message.calibration.baseline = cameras.stereo.baseline * settings.b_scale;
  message.width = images.left.cols;
  message.height = images.left.rows;
  message.encoding = jpeg_quality == 0 ? StereoFrame::ENCODING_BGR8 : StereoFrame::ENCODING_JPEG;
  message.left = encoded(images.left, jpeg_quality);
  message.right = encoded(images.right, jpeg_quality);
  message.left_size = static_cast<std::int32_t>(message.left.size());
  message.right_size = static_cast<std::int32_t>(message.right.size());
  return message;
}

}  // namespace markservo::simulator
