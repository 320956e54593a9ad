#include "services/stereo-camera/files/motion_signal.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace markservo::stereo_camera {

void MotionMeter::add(const cv::Mat& bgr, double time_s) {
  if (bgr.empty() || bgr.type() != CV_8UC3) throw std::invalid_argument("MotionMeter: picture is not 8-bit colour");
  cv::Mat grey;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  const int width = std::min(parameters_.width_px, grey.cols);
  const int height = std::max(1, grey.rows * width / grey.cols);
  cv::Mat small;
  cv::resize(grey, small, cv::Size(width, height), 0.0, 0.0, cv::INTER_AREA);
  small.convertTo(small, CV_32F);
  if (small.size() == last_.size()) {
    if (!(time_s > last_s_)) throw std::invalid_argument("MotionMeter: time does not rise");
    const cv::Mat change = small - last_;
    const double moved = cv::mean(cv::abs(change - cv::mean(change)[0]))[0];
    steps_.push_back({last_s_, time_s, moved / (time_s - last_s_)});
  }
  last_ = small;
  last_s_ = time_s;
}

}  // namespace markservo::stereo_camera
