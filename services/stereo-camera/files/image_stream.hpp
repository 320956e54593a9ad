#pragma once

// One side's pictures from files, in order.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace markservo::stereo_camera {

enum class StreamStatus { kImage, kUnreadable, kEnd };

struct StreamResult {
  StreamStatus status = StreamStatus::kEnd;
  cv::Mat image;       // BGR, 8 bits
  std::string reason;  // where unreadable
};

class ImageStream {
 public:
  virtual ~ImageStream() = default;
  virtual StreamResult next() = 0;

  // Back to the first picture.
  virtual void rewind() = 0;

  // Frames per second as the file states it; 0 where it does not.
  virtual double rate() const = 0;
};

}  // namespace markservo::stereo_camera
