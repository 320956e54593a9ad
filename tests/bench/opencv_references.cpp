#include "tests/bench/opencv_references.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace markservo::bench {

BlockMatching::BlockMatching(int min_disparity, int num_disparities) {
  constexpr int kBlock = 15;  // px a side
  matcher_ = cv::StereoBM::create(num_disparities, kBlock);
  matcher_->setMinDisparity(min_disparity);
}

const cv::Mat& BlockMatching::run(const cv::Mat& left, const cv::Mat& right) {
  cv::cvtColor(left, left_, cv::COLOR_BGR2GRAY);
  cv::cvtColor(right, right_, cv::COLOR_BGR2GRAY);
  matcher_->compute(left_, right_, disparities_);
  return disparities_;
}

int CornersAndFlow::run(const cv::Mat& left, const cv::Mat& right) {
  constexpr int kCorners = 200;
  constexpr double kQuality = 0.01;
  constexpr double kSpacing = 7.0;  // px
  cv::cvtColor(left, left_, cv::COLOR_BGR2GRAY);
  cv::cvtColor(right, right_, cv::COLOR_BGR2GRAY);
  cv::goodFeaturesToTrack(left_, corners_, kCorners, kQuality, kSpacing);
  if (corners_.empty()) return 0;
  cv::calcOpticalFlowPyrLK(left_, right_, corners_, followed_, found_, errors_);
  return static_cast<int>(std::count(found_.begin(), found_.end(), uchar{1}));
}

}  // namespace markservo::bench
