#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace markservo::stereo_camera {

// A picture of a video file, upright, and when it is shown.
struct VideoPicture {
  cv::Mat image;                        // BGR, 8 bits; a buffer of its own
  std::optional<std::int64_t> time_us;  // on the file's own time line; absent where the file states none
};

// Decodes the pictures of a video file one by one, by FFmpeg's libraries: cv::VideoCapture leaves out where a file's
// time begins and turns pictures the wrong way round.
class VideoDecoder {
 public:
  // Throws std::runtime_error, which says why, for what is no video. Only files are opened, whatever they refer to.
  explicit VideoDecoder(const std::string& path);
  ~VideoDecoder();
  VideoDecoder(const VideoDecoder&) = delete;
  VideoDecoder& operator=(const VideoDecoder&) = delete;

  // The next picture in the order of showing; nothing at the end. What cannot be decoded is left out.
  std::optional<VideoPicture> next();

  // Pictures per second on the average, as the file states it; 0 where it does not.
  double rate() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace markservo::stereo_camera
