#pragma once

// Where image pairs come from: one call, one pair, or why there is none.

#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

namespace markservo::stereo_camera {

// Two pictures of one moment as the cameras gave them, BGR, 8 bits.
struct RawPair {
  cv::Mat left;
  cv::Mat right;
  std::int64_t index = 0;                      // of the source, from 0; pairs that were dropped count as well
  std::optional<std::int64_t> exposure_utime;  // us since the epoch, where the source knows it
};

enum class ReadStatus {
  kPair,     // `pair` holds the next one
  kDropped,  // a pair or a picture had to be thrown away; `reason` says why
  kWaiting,  // a camera is not there; the source tries again at the next call
  kEnd,      // files only: no more
};

struct ReadResult {
  ReadStatus status = ReadStatus::kEnd;
  RawPair pair;
  std::string reason;  // one line; empty where there is nothing to say
};

class FrameSource {
 public:
  virtual ~FrameSource() = default;

  // The next pair. Cameras block for up to about a second; files do not wait.
  virtual ReadResult read() = 0;
};

// Why the pictures are no usable pair of `expected` size each (any size where that is empty); empty when they are.
std::string pair_complaint(const cv::Mat& left, const cv::Mat& right, cv::Size expected);

// "640 x 480 px", for messages.
std::string size_text(cv::Size size);

}  // namespace markservo::stereo_camera
