#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

std::string size_text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height) + " px";
}

std::string pair_complaint(const cv::Mat& left, const cv::Mat& right, cv::Size expected) {
  if (left.empty() || right.empty()) return std::string(left.empty() ? "left" : "right") + " picture is empty";
  if (left.type() != CV_8UC3 || right.type() != CV_8UC3) return "pictures are not 8-bit colour";
  if (left.size() != right.size()) {
    return "left picture is " + size_text(left.size()) + ", right picture is " + size_text(right.size()) +
           "; allowed: the same size";
  }
  if (!expected.empty() && left.size() != expected) {
    return "pictures are " + size_text(left.size()) + "; allowed: " + size_text(expected);
  }
  return "";
}

}  // namespace markservo::stereo_camera
