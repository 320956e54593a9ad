#include "services/mark-detector/detection_message.hpp"

#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>
#include <utility>

namespace markservo::mark_detector {
namespace {

MarkPatch message_of(const Patch& patch) {
  MarkPatch message{};
  message.x = patch.x;
  message.y = patch.y;
  message.scale = patch.scale;
  message.width = patch.width;
  message.height = patch.height;
  message.bgr_size = static_cast<std::int32_t>(patch.bgr.size());
  message.bgr = patch.bgr;
  message.mask_size = static_cast<std::int32_t>(patch.mask.size());
  message.mask = patch.mask;
  return message;
}

MarkView message_of(const View& view) {
  MarkView message{};
  message.seen = view.seen ? 1 : 0;
  message.clipped = view.clipped ? 1 : 0;
  message.x = view.shape.x;
  message.y = view.shape.y;
  message.width = view.shape.width;
  message.height = view.shape.height;
  message.area = view.shape.area;
  message.u = view.shape.u;
  message.v = view.shape.v;
  message.m_uu = view.shape.m_uu;
  message.m_uv = view.shape.m_uv;
  message.m_vv = view.shape.m_vv;
  message.patch = message_of(view.patch);
  return message;
}

}  // namespace

MarkDetection make_message(const StereoFrame& frame, const Output& output) {
  MarkDetection message{};
  message.utime = frame.utime;
  message.frame_session = frame.session;
  message.frame_seq = frame.seq;
  message.frame_utime = frame.utime;
  message.width = frame.width;
  message.height = frame.height;
  message.calibration = frame.calibration;
  message.num_marks = static_cast<std::int32_t>(output.marks.size());
  message.marks.reserve(output.marks.size());
  for (const Finding& finding : output.marks) {
    DetectedMark mark{};
    mark.name = finding.name;
    mark.role = finding.role == robot::MarkRole::kTarget ? DetectedMark::ROLE_TARGET : DetectedMark::ROLE_MANIPULATOR;
    mark.separability = finding.separability;
    mark.reason = finding.reason;
    mark.left = message_of(finding.left);
    mark.right = message_of(finding.right);
    message.marks.push_back(std::move(mark));
  }
  return message;
}

}  // namespace markservo::mark_detector
