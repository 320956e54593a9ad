#pragma once

#include <opencv2/videoio.hpp>
#include <string>

#include "services/stereo-camera/files/image_stream.hpp"

namespace markservo::stereo_camera {

// A video file. Ends where no further frame can be decoded.
class VideoStream : public ImageStream {
 public:
  // Throws ConfigurationError where the file is not there or no video; `option` names the setting in the message.
  VideoStream(const std::string& path, const std::string& option);

  StreamResult next() override;
  void rewind() override;
  double rate() const override { return rate_; }

 private:
  std::string path_;
  cv::VideoCapture capture_;
  double rate_ = 0.0;
};

}  // namespace markservo::stereo_camera
