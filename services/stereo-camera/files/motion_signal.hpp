#pragma once

// How much moves in a video, over time: what two cameras that look at one scene have in common whatever their views.

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

namespace markservo::stereo_camera {

// What changed from one picture to the next.
struct MotionStep {
  double begin_s = 0.0;  // of the earlier picture
  double end_s = 0.0;    // of the later one, above begin_s
  double rate = 0.0;     // mean absolute change of a pixel, grey levels a second
};

class MotionMeter {
 public:
  struct Parameters {
    // Pictures are made this small, which averages the sensor's noise and leaves whole things' motion.
    int width_px = 80;
  };

  MotionMeter() : MotionMeter(Parameters{}) {}
  explicit MotionMeter(const Parameters& parameters) : parameters_(parameters) {}

  // The next picture (BGR, 8 bits, not empty) and its time, later than the one before. A change of the whole picture's
  // brightness is an exposure's, not a motion's, and does not count.
  void add(const cv::Mat& bgr, double time_s);

  const std::vector<MotionStep>& steps() const { return steps_; }

 private:
  Parameters parameters_;
  cv::Mat last_;  // CV_32F
  double last_s_ = 0.0;
  std::vector<MotionStep> steps_;
};

}  // namespace markservo::stereo_camera
