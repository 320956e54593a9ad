#pragma once

// What one cv::imdecode of both pictures of a frame takes, as a measure that others know.

#include <markservo/StereoFrame.hpp>
#include <vector>

namespace markservo::bench {

class UnpackingCost {
 public:
  // Unpacks both pictures of each of some JPEG frames, one picture after the other.
  void measure(const std::vector<StereoFrame>& frames);

  double median_ms() const;  // of one frame; NaN before anything was measured

 private:
  std::vector<double> seconds_;
};

}  // namespace markservo::bench
