#include "tests/experiments/demo_pictures.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "common/frames/frame_side.hpp"

namespace markservo::experiments {
namespace {

const cv::Scalar kInk(255, 255, 255);
const cv::Scalar kShade(30, 30, 30);
constexpr int kTitleHeight = 28;  // px
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kTitleScale = 0.45;
constexpr double kLabelScale = 0.38;
constexpr int kLineHeight = 15;  // px, of a label
// Frames wait for their answers; more than this late is another matter.
constexpr std::size_t kRemembered = 8;

template <class Message>
void remember(std::deque<Message>& messages, const Message& message) {
  messages.push_back(message);
  if (messages.size() > kRemembered) messages.pop_front();
}

template <class Answer>
const Answer* answer_to(const StereoFrame& frame, const std::deque<Answer>& answers) {
  for (auto answer = answers.rbegin(); answer != answers.rend(); ++answer) {
    if (answer->frame_session == frame.session && answer->frame_seq == frame.seq) return &*answer;
  }
  return nullptr;
}

cv::Mat decode(const StereoFrame& frame, const std::vector<std::uint8_t>& side, const char* name) {
  frames::JpegDecoder decoder;
  return frames::picture_of(frame, side, name, decoder).clone();
}

void write_text(cv::Mat& image, const std::string& text, cv::Point at, double scale) {
  cv::putText(image, text, at, kFont, scale, kShade, 3, cv::LINE_AA);
  cv::putText(image, text, at, kFont, scale, kInk, 1, cv::LINE_AA);
}

cv::Rect box_of(const MarkView& view) {
  return {view.x, view.y, view.width, view.height};
}

void draw_box(cv::Mat& image, const MarkView& view) {
  if (!view.seen) return;
  cv::rectangle(image, box_of(view), kShade, 3);
  cv::rectangle(image, box_of(view), kInk, 1);
}

// A mark's name and position: two lines below its box, further down where another label or box is in the way.
void draw_label(cv::Mat& image, const LocatedMark& mark, const MarkView& view, std::vector<cv::Rect>& taken) {
  char position[64];
  std::snprintf(position, sizeof position, "%.1f %.1f %.1f mm", 1e3 * mark.p_C.x, 1e3 * mark.p_C.y, 1e3 * mark.p_C.z);
  const int width = std::max(cv::getTextSize(mark.name, kFont, kLabelScale, 1, nullptr).width,
                             cv::getTextSize(position, kFont, kLabelScale, 1, nullptr).width);
  cv::Rect place(view.x + view.width / 2 - width / 2, view.y + view.height + 4, width, 2 * kLineHeight);
  place.x = std::clamp(place.x, 2, std::max(2, image.cols - width - 2));
  const auto in_the_way = [&](const cv::Rect& other) { return (other & place).area() > 0; };
  while (place.br().y < image.rows && std::any_of(taken.begin(), taken.end(), in_the_way)) place.y += kLineHeight / 2;
  place.y = std::min(place.y, image.rows - place.height);
  taken.emplace_back(place.x - 4, place.y, place.width + 8, place.height);
  write_text(image, mark.name, {place.x, place.y + kLineHeight - 4}, kLabelScale);
  write_text(image, position, {place.x, place.y + 2 * kLineHeight - 4}, kLabelScale);
}

void draw_labels(cv::Mat& image, const TargetPose& pose, const MarkDetection& detection) {
  std::vector<cv::Rect> taken;
  for (const auto& mark : detection.marks) {
    if (mark.left.seen) taken.push_back(box_of(mark.left));
  }
  for (const auto& located : pose.marks) {
    if (located.status != LocatedMark::LOCATED) continue;
    for (const auto& mark : detection.marks) {
      if (mark.name == located.name) draw_label(image, located, mark.left, taken);
    }
  }
}

}  // namespace

Eyes::Eyes(bus::Bus& bus, std::function<void(std::int64_t seq)> on_frame) {
  bus.on_each(channels::kStereoFrame, [this, told = std::move(on_frame)](const StereoFrame& frame) {
    told(frame.seq);
    remember(frames_, frame);
  });
  bus.on_each(channels::kMarkDetection, [this](const MarkDetection& message) { remember(detections_, message); });
  bus.on_each(channels::kStereoMatches, [this](const StereoMatches& message) { remember(matches_, message); });
  bus.on_each(channels::kTargetPose, [this](const TargetPose& message) { remember(poses_, message); });
}

void Eyes::write(const std::string& path, const std::string& title) const {
  if (frames_.empty()) return;
  const auto complete = std::find_if(frames_.rbegin(), frames_.rend(), [this](const StereoFrame& frame) {
    return answer_to(frame, detections_) != nullptr && answer_to(frame, matches_) != nullptr &&
           answer_to(frame, poses_) != nullptr;
  });
  const StereoFrame& frame = complete == frames_.rend() ? frames_.back() : *complete;
  cv::Mat left = decode(frame, frame.left, "left");
  cv::Mat right = decode(frame, frame.right, "right");
  if (left.empty() || right.empty()) return;
  const MarkDetection* detection = answer_to(frame, detections_);
  if (detection != nullptr) {
    for (const auto& mark : detection->marks) {
      draw_box(left, mark.left);
      draw_box(right, mark.right);
    }
  }
  if (const StereoMatches* matches = answer_to(frame, matches_)) {
    for (const auto& mark : matches->marks) {
      for (std::size_t i = 0; i < mark.u_left.size(); ++i) {
        cv::circle(left, cv::Point2d(mark.u_left[i], mark.v_left[i]), 2, kInk, 1, cv::LINE_AA);
        cv::circle(right, cv::Point2d(mark.u_right[i], mark.v_right[i]), 2, kInk, 1, cv::LINE_AA);
      }
    }
  }
  const TargetPose* pose = answer_to(frame, poses_);
  if (pose != nullptr && detection != nullptr) draw_labels(left, *pose, *detection);
  cv::Mat both;
  cv::hconcat(left, right, both);
  cv::copyMakeBorder(both, both, kTitleHeight, 0, 0, 0, cv::BORDER_CONSTANT, kShade);
  write_text(both, title + "   (left and right camera; positions x right, y forward, z up from the left lens)", {8, 19},
             kTitleScale);
  cv::imwrite(path, both);
}

}  // namespace markservo::experiments
