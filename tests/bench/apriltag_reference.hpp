#pragma once

// The search for AprilTags of the family 36h11, at half the resolution (quad_decimate 2), on one thread.

#include <memory>
#include <opencv2/core.hpp>

namespace markservo::bench {

class TagSearch {
 public:
  TagSearch();
  ~TagSearch();
  TagSearch(const TagSearch&) = delete;
  TagSearch& operator=(const TagSearch&) = delete;

  // The number of tags in both 8-bit BGR images together.
  int run(const cv::Mat& left, const cv::Mat& right);

 private:
  struct Detector;  // of libapriltag
  int search(const cv::Mat& image);

  std::unique_ptr<Detector> detector_;
  cv::Mat grey_;
};

}  // namespace markservo::bench
