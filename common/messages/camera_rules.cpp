// The rules of what cameras, detector and locator say: images, and marks in them and in space.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>

#include "common/geometry/camera_bounds.hpp"
#include "common/messages/covariance_rule.hpp"
#include "common/messages/vector_rule.hpp"

namespace markservo::messages {
namespace {

constexpr std::int32_t kMaxImageSide = 16384;  // px
constexpr std::int64_t kMaxFramePixels = std::int64_t{1}
                                         << 25;  // 100 MB a side as BGR; a JPEG of a few bytes can claim any size
constexpr double kMaxMarkVariance = 4e5;         // m^2; an answer may add two marks' and stays below kMaxCovariance

std::string calibration_violation(const StereoCalibration& c) {
  if (!all_finite({c.fx, c.fy, c.cx_left, c.cx_right, c.cy, c.baseline})) return not_finite("calibration");
  if (c.fx <= 0.0) return wrong("calibration.fx", c.fx, "above 0 px");
  if (c.fy <= 0.0) return wrong("calibration.fy", c.fy, "above 0 px");
  if (const auto bounds = geometry::kBaselineBounds; !bounds.hold(c.baseline)) {
    return wrong("calibration.baseline", c.baseline, fmt::format("{:.6g} to {:.6g} m", bounds.min, bounds.max));
  }
  return {};
}

std::string size_violation(const std::string& of, std::int32_t width, std::int32_t height) {
  if (width < 1 || width > kMaxImageSide) return wrong(of + "width", width, "1 to 16384 px");
  if (height < 1 || height > kMaxImageSide) return wrong(of + "height", height, "1 to 16384 px");
  return {};
}

std::string patch_violation(const MarkPatch& patch) {
  if (patch.scale == 0) {
    return patch.bgr_size == 0 && patch.mask_size == 0 ? "" : "patch of scale 0 carries pixels; allowed: none";
  }
  if (patch.scale < 0) return wrong("patch.scale", patch.scale, "0 or more");
  if (auto why = size_violation("patch.", patch.width, patch.height); !why.empty()) return why;
  if (patch.bgr_size != patch.width * patch.height * 3) {
    return wrong("patch.bgr_size", patch.bgr_size, "width * height * 3 bytes");
  }
  if (patch.mask_size != patch.height * ((patch.width + 7) / 8)) {
    return wrong("patch.mask_size", patch.mask_size, "height * ((width + 7) / 8) bytes");
  }
  return {};
}

std::string view_violation(const MarkView& view) {
  if (!all_finite({view.area, view.u, view.v, view.m_uu, view.m_uv, view.m_vv})) return not_finite("view");
  if (view.seen && view.width < 1) return wrong("view.width", view.width, "1 px or more when seen");
  if (view.seen && view.height < 1) return wrong("view.height", view.height, "1 px or more when seen");
  return patch_violation(view.patch);
}

template <class Detection, class Visit>
void each_text_of_detection(Detection& detection, Visit& visit) {
  for (auto& mark : detection.marks) {
    visit("a mark's name", mark.name);
    visit("a mark's reason", mark.reason);
  }
}

// TargetPose and StereoMatches.
template <class Message, class Visit>
void each_name(Message& message, Visit& visit) {
  for (auto& mark : message.marks) visit("a mark's name", mark.name);
}

}  // namespace

std::string MessageRules<StereoFrame>::violation(const StereoFrame& frame) {
  if (auto why = size_violation("", frame.width, frame.height); !why.empty()) return why;
  const std::int64_t pixels = static_cast<std::int64_t>(frame.width) * frame.height;
  if (pixels > kMaxFramePixels) return wrong("width * height", pixels, "at most 33554432 px");
  if (auto why = calibration_violation(frame.calibration); !why.empty()) return why;
  if (frame.encoding == StereoFrame::ENCODING_BGR8) {
    const std::int64_t size = 3 * pixels;
    if (frame.left_size != size) return wrong("left_size", frame.left_size, "width * height * 3 bytes for BGR8");
    if (frame.right_size != size) return wrong("right_size", frame.right_size, "width * height * 3 bytes for BGR8");
  } else if (frame.encoding != StereoFrame::ENCODING_JPEG) {
    return wrong("encoding", frame.encoding, "0 (BGR8) or 1 (JPEG)");
  }
  return {};
}

std::string MessageRules<MarkDetection>::violation(const MarkDetection& detection) {
  TextCheck texts;
  each_text_of_detection(detection, texts);
  if (!texts.why().empty()) return texts.why();
  if (auto why = size_violation("", detection.width, detection.height); !why.empty()) return why;
  if (auto why = calibration_violation(detection.calibration); !why.empty()) return why;
  for (const auto& mark : detection.marks) {
    if (auto why = enum_violation("role", mark.role, DetectedMark::ROLE_MANIPULATOR); !why.empty()) return why;
    if (!std::isfinite(mark.separability)) return not_finite("separability");
    for (const auto* view : {&mark.left, &mark.right}) {
      if (auto why = view_violation(*view); !why.empty()) return "mark " + mark.name + ": " + why;
    }
  }
  return {};
}

void MessageRules<MarkDetection>::clean_texts(MarkDetection& detection) {
  TextCleaner cleaner;
  each_text_of_detection(detection, cleaner);
}

std::string MessageRules<TargetPose>::violation(const TargetPose& pose) {
  TextCheck texts;
  each_name(pose, texts);
  if (!texts.why().empty()) return texts.why();
  for (const auto& mark : pose.marks) {
    if (auto why = enum_violation("role", mark.role, DetectedMark::ROLE_MANIPULATOR); !why.empty()) return why;
    if (auto why = enum_violation("status", mark.status, LocatedMark::INCONSISTENT); !why.empty()) return why;
    if (auto why = enum_violation("cue", mark.cue, LocatedMark::CUE_CENTROID); !why.empty()) return why;
    if (auto why = near_violation("p_C", mark.p_C); !why.empty()) return "mark " + mark.name + ": " + why;
    if (auto why = near_violation("normal_C", mark.normal_C); !why.empty()) return "mark " + mark.name + ": " + why;
    if (auto why = covariance_violation(mark.covariance, kMaxMarkVariance); !why.empty()) {
      return "mark " + mark.name + ": " + why;
    }
    if (auto why = count_violation("num_features", mark.num_features); !why.empty()) return why;
  }
  return {};
}

void MessageRules<TargetPose>::clean_texts(TargetPose& pose) {
  TextCleaner cleaner;
  each_name(pose, cleaner);
}

std::string MessageRules<StereoMatches>::violation(const StereoMatches& matches) {
  TextCheck texts;
  each_name(matches, texts);
  if (!texts.why().empty()) return texts.why();
  for (const auto& mark : matches.marks) {
    for (const auto* column : {&mark.u_left, &mark.v_left, &mark.u_right, &mark.v_right, &mark.residual}) {
      if (!all_finite(*column)) return not_finite("a match of mark " + mark.name);
    }
  }
  return {};
}

void MessageRules<StereoMatches>::clean_texts(StereoMatches& matches) {
  TextCleaner cleaner;
  each_name(matches, cleaner);
}

}  // namespace markservo::messages
