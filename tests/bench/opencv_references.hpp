#pragma once

// Ways to measure with OpenCV that need no colour. Each takes 8-bit BGR images, makes them grey and keeps its buffers.

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <vector>

namespace markservo::bench {

// cv::StereoBM over the disparities min_disparity .. min_disparity + num_disparities - 1.
class BlockMatching {
 public:
  BlockMatching(int min_disparity, int num_disparities);
  // 16-bit, sixteenths of a px.
  const cv::Mat& run(const cv::Mat& left, const cv::Mat& right);

 private:
  cv::Ptr<cv::StereoBM> matcher_;
  cv::Mat left_;
  cv::Mat right_;
  cv::Mat disparities_;
};

// cv::goodFeaturesToTrack, 200 of the whole left image, followed into the right one by cv::calcOpticalFlowPyrLK.
class CornersAndFlow {
 public:
  // How many were followed.
  int run(const cv::Mat& left, const cv::Mat& right);

 private:
  cv::Mat left_;
  cv::Mat right_;
  std::vector<cv::Point2f> corners_;
  std::vector<cv::Point2f> followed_;
  std::vector<uchar> found_;
  std::vector<float> errors_;
};

}  // namespace markservo::bench
