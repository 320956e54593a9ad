#include "tests/experiments/demo_pictures.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace markservo::experiments {
namespace {

const cv::Scalar kInk(255, 255, 255);
const cv::Scalar kShade(30, 30, 30);
constexpr int kTitleHeight = 28;  // px

cv::Mat decode(const StereoFrame& frame, const std::vector<uint8_t>& bytes) {
  if (frame.encoding == StereoFrame::ENCODING_JPEG) return cv::imdecode(bytes, cv::IMREAD_COLOR);
  return cv::Mat(frame.height, frame.width, CV_8UC3, const_cast<uint8_t*>(bytes.data())).clone();
}

void write_text(cv::Mat& image, const std::string& text, cv::Point at) {
  cv::putText(image, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, kShade, 3, cv::LINE_AA);
  cv::putText(image, text, at, cv::FONT_HERSHEY_SIMPLEX, 0.45, kInk, 1, cv::LINE_AA);
}

void draw_box(cv::Mat& image, const MarkView& view) {
  if (!view.seen) return;
  const cv::Rect box(view.x, view.y, view.width, view.height);
  cv::rectangle(image, box, kShade, 3);
  cv::rectangle(image, box, kInk, 1);
}

template <class Answer>
bool answers(const Answer& answer, const StereoFrame& frame) {
  return answer.frame_session == frame.session && answer.frame_seq == frame.seq;
}

std::string position_text(const LocatedMark& mark) {
  char text[96];
  std::snprintf(text, sizeof text, "%s %.1f %.1f %.1f mm", mark.name.c_str(), 1e3 * mark.p_C.x, 1e3 * mark.p_C.y,
                1e3 * mark.p_C.z);
  return text;
}

}  // namespace

void write_annotated_picture(const std::string& path, const StereoFrame& frame, const MarkDetection& detection,
                             const StereoMatches& matches, const TargetPose& pose, const std::string& title) {
  cv::Mat left = decode(frame, frame.left);
  cv::Mat right = decode(frame, frame.right);
  if (left.empty() || right.empty()) return;
  if (answers(detection, frame)) {
    for (const auto& mark : detection.marks) {
      draw_box(left, mark.left);
      draw_box(right, mark.right);
    }
  }
  if (answers(matches, frame)) {
    for (const auto& mark : matches.marks) {
      for (std::size_t i = 0; i < mark.u_left.size(); ++i) {
        cv::circle(left, cv::Point2d(mark.u_left[i], mark.v_left[i]), 2, kInk, 1, cv::LINE_AA);
        cv::circle(right, cv::Point2d(mark.u_right[i], mark.v_right[i]), 2, kInk, 1, cv::LINE_AA);
      }
    }
  }
  if (answers(pose, frame) && answers(detection, frame)) {
    for (const auto& located : pose.marks) {
      if (located.status != LocatedMark::LOCATED) continue;
      for (const auto& mark : detection.marks) {
        if (mark.name == located.name) {
          write_text(left, position_text(located),
                     {mark.left.x, mark.left.y > 20 ? mark.left.y - 6 : mark.left.y + mark.left.height + 16});
        }
      }
    }
  }
  cv::Mat both;
  cv::hconcat(left, right, both);
  cv::copyMakeBorder(both, both, kTitleHeight, 0, 0, 0, cv::BORDER_CONSTANT, kShade);
  write_text(both, title + "   (left and right camera; positions x right, y forward, z up from the left lens)",
             {8, 19});
  cv::imwrite(path, both);
}

}  // namespace markservo::experiments
