#include "services/stereo-camera/files/video_stream.hpp"

#include <cmath>
#include <filesystem>
#include <system_error>

#include "common/robot/configuration_error.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMaxRate_hz = 1000.0;  // files without a time base state nonsense such as 90000

}  // namespace

VideoStream::VideoStream(const std::string& path, const std::string& option) : path_(path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw ConfigurationError(option + " is '" + path +
                             "', which is no file; allowed: a picture, a video, or a pattern "
                             "as left_%02d.png");
  }
  VideoStream::rewind();  // not virtual while it is being made
  if (!capture_.isOpened()) {
    throw ConfigurationError(option + " is '" + path + "', which is no readable video; allowed: what FFmpeg decodes");
  }
  rate_ = capture_.get(cv::CAP_PROP_FPS);
  if (!std::isfinite(rate_) || rate_ <= 0.0 || rate_ > kMaxRate_hz) rate_ = 0.0;
}

StreamResult VideoStream::next() {
  StreamResult result;
  try {
    cv::Mat frame;
    if (!capture_.read(frame) || frame.empty()) return result;
    // The decoder reuses its buffer for the next frame.
    result.image = frame.clone();
    result.status = StreamStatus::kImage;
  } catch (const cv::Exception& error) {
    result.status = StreamStatus::kUnreadable;
    result.reason = path_ + ": " + error.err;
  }
  return result;
}

void VideoStream::rewind() {
  // Opened afresh: seeking is inexact in many containers. FFmpeg alone, so that a name is never taken as a pipeline.
  capture_.release();
  capture_.open(path_, cv::CAP_FFMPEG);
}

}  // namespace markservo::stereo_camera
