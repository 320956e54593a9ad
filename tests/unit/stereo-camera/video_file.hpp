#pragma once

// Writes small video files with times and turns as a test wants them.

#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace markservo::stereo_camera {

struct TimedImage {
  std::int64_t time_ms = 0;
  cv::Mat image;  // BGR, 8 bits, all of one size of even edges
};

struct VideoFormat {
  double rate_hz = 30.0;                         // that the file states
  std::array<std::int32_t, 9> display_matrix{};  // as libavutil/display.h has it; zeros: none
};

// The container follows from the path's end: .mkv and .avi (lossless), .mp4 and .ts (MPEG-4 part 2). Throws
// std::runtime_error.
void write_video(const std::string& path, const std::vector<TimedImage>& images, const VideoFormat& format = {});

}  // namespace markservo::stereo_camera
