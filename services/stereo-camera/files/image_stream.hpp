#pragma once

// One side's pictures from files, in order.

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

namespace markservo::stereo_camera {

enum class StreamStatus { kImage, kUnreadable, kEnd };

struct StreamResult {
  StreamStatus status = StreamStatus::kEnd;
  cv::Mat image;  // BGR, 8 bits
  // On the stream's own time line, of an unreadable picture as well; rises from one to the next.
  std::int64_t time_us = 0;
  std::string reason;  // where unreadable
};

class ImageStream {
 public:
  virtual ~ImageStream() = default;
  virtual StreamResult next() = 0;

  // Back to the first picture.
  virtual void rewind() = 0;

  // Pictures per second: as the file states it, or as it was told to play; 0 where neither is known.
  virtual double rate() const = 0;
};

}  // namespace markservo::stereo_camera
