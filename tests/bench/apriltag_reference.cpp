#include "tests/bench/apriltag_reference.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <opencv2/imgproc.hpp>

namespace markservo::bench {

struct TagSearch::Detector {
  Detector() {
    search->quad_decimate = 2.0F;
    search->nthreads = 1;
    apriltag_detector_add_family(search, family);
  }
  ~Detector() {
    apriltag_detector_destroy(search);
    tag36h11_destroy(family);
  }
  Detector(const Detector&) = delete;
  Detector& operator=(const Detector&) = delete;

  apriltag_family_t* family = tag36h11_create();
  apriltag_detector_t* search = apriltag_detector_create();
};

TagSearch::TagSearch() : detector_(std::make_unique<Detector>()) {}
TagSearch::~TagSearch() = default;

int TagSearch::run(const cv::Mat& left, const cv::Mat& right) {
  return search(left) + search(right);
}

int TagSearch::search(const cv::Mat& image) {
  cv::cvtColor(image, grey_, cv::COLOR_BGR2GRAY);
  image_u8_t view{grey_.cols, grey_.rows, static_cast<int>(grey_.step), grey_.data};
  zarray_t* const found = apriltag_detector_detect(detector_->search, &view);
  const int count = zarray_size(found);
  apriltag_detections_destroy(found);
  return count;
}

}  // namespace markservo::bench
