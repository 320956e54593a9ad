#pragma once

// What the task's pictures are made of: the last few frames and what the services said of them.

#include <cstdint>
#include <deque>
#include <functional>
#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <string>

#include "common/bus/bus.hpp"

namespace markservo::experiments {

class Eyes {
 public:
  // `on_frame` is told the seq of every frame that is heard.
  Eyes(bus::Bus& bus, std::function<void(std::int64_t seq)> on_frame);

  // Writes the newest frame that all answers are known of (else the newest frame) as a PNG: left and right image side
  // by side, with the boxes, the matched points and the measured positions of the marks.
  void write(const std::string& path, const std::string& title) const;

 private:
  std::deque<StereoFrame> frames_;
  std::deque<MarkDetection> detections_;
  std::deque<StereoMatches> matches_;
  std::deque<TargetPose> poses_;
};

}  // namespace markservo::experiments
