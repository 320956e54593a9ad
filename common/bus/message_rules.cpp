#include "common/bus/message_rules.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "common/bus/rule_words.hpp"

namespace markservo::bus {
namespace {

constexpr int32_t kMaxImageSide = 16384;               // px
constexpr int64_t kMaxFramePixels = int64_t{1} << 25;  // 100 MB a side as BGR; a JPEG of a few bytes can claim any size
constexpr double kMaxMarkVariance = 4e5;               // m^2; an answer may add two marks' and stays below the above

bool all_finite(const std::vector<double>& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool finite(const Vector3& v) {
  return all_finite({v.x, v.y, v.z});
}

// Finite, and so near that sums and squares of it stay finite too.
bool near(const Vector3& v) {
  return finite(v) && std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= kMaxPosition;
}

std::string not_near(const char* field) {
  return std::string(field) + " is not finite or beyond 10 km; allowed: -10000 to 10000 m";
}

std::string calibration_violation(const StereoCalibration& c) {
  if (!all_finite({c.fx, c.fy, c.cx_left, c.cx_right, c.cy, c.baseline})) return not_finite("calibration");
  if (c.fx <= 0.0) return wrong("calibration.fx", c.fx, "above 0 px");
  if (c.fy <= 0.0) return wrong("calibration.fy", c.fy, "above 0 px");
  if (c.baseline <= 0.0) return wrong("calibration.baseline", c.baseline, "above 0 m");
  return {};
}

std::string size_violation(int32_t width, int32_t height) {
  if (width < 1 || width > kMaxImageSide) return wrong("width", width, "1 to 16384 px");
  if (height < 1 || height > kMaxImageSide) return wrong("height", height, "1 to 16384 px");
  return {};
}

std::string patch_violation(const MarkPatch& patch) {
  if (patch.scale == 0) {
    return patch.bgr_size == 0 && patch.mask_size == 0 ? "" : "patch of scale 0 carries pixels; allowed: none";
  }
  if (patch.scale < 0) return wrong("patch.scale", patch.scale, "0 or more");
  if (auto why = size_violation(patch.width, patch.height); !why.empty()) return "patch." + why;
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
  if (view.seen && (view.width < 1 || view.height < 1))
    return wrong("view.width or height", 0, "1 px or more when seen");
  return patch_violation(view.patch);
}

std::string joints_violation(int32_t num_joints, std::initializer_list<const std::vector<double>*> vectors) {
  constexpr int32_t kMaxJoints = 16;
  if (num_joints < 0 || num_joints > kMaxJoints) return wrong("num_joints", num_joints, "0 to 16");
  for (const auto* vector : vectors) {
    if (!all_finite(*vector)) return not_finite("a joint's value");
    for (const double value : *vector) {
      if (std::abs(value) > kMaxAngle) return wrong("a joint's value", value, "-10000 to 10000 rad or rad/s");
    }
  }
  return {};
}

std::string gripper_violation(double opening, double force) {
  if (!std::isfinite(opening) || opening < 0.0) return wrong("gripper_opening", opening, "0 m or more");
  if (!std::isfinite(force) || force < 0.0) return wrong("gripper_force", force, "0 N or more");
  return {};
}

std::string covariance_violation(const Covariance3& c, double most) {
  if (!all_finite({c.xx, c.xy, c.xz, c.yy, c.yz, c.zz})) return not_finite("covariance");
  for (const double variance : {c.xx, c.yy, c.zz}) {
    if (variance < 0.0 || variance > most) {
      const std::string allowed = "0 to " + std::to_string(static_cast<int>(most)) + " m^2 on the diagonal";
      return wrong("covariance", variance, allowed.c_str());
    }
  }
  return {};
}

}  // namespace

std::string violation(const StereoFrame& frame) {
  if (auto why = size_violation(frame.width, frame.height); !why.empty()) return why;
  const int64_t pixels = static_cast<int64_t>(frame.width) * frame.height;
  if (pixels > kMaxFramePixels) return wrong("width * height", static_cast<double>(pixels), "at most 33554432 px");
  if (auto why = calibration_violation(frame.calibration); !why.empty()) return why;
  if (frame.encoding == StereoFrame::ENCODING_BGR8) {
    const int64_t size = 3 * pixels;
    if (frame.left_size != size) return wrong("left_size", frame.left_size, "width * height * 3 bytes for BGR8");
    if (frame.right_size != size) return wrong("right_size", frame.right_size, "width * height * 3 bytes for BGR8");
  } else if (frame.encoding != StereoFrame::ENCODING_JPEG) {
    return wrong("encoding", frame.encoding, "0 (BGR8) or 1 (JPEG)");
  }
  return {};
}

std::string violation(const MarkDetection& detection) {
  if (auto why = size_violation(detection.width, detection.height); !why.empty()) return why;
  if (auto why = calibration_violation(detection.calibration); !why.empty()) return why;
  for (const auto& mark : detection.marks) {
    if (!std::isfinite(mark.separability)) return not_finite("separability");
    for (const auto* view : {&mark.left, &mark.right}) {
      if (auto why = view_violation(*view); !why.empty()) return "mark " + mark.name + ": " + why;
    }
  }
  return {};
}

std::string violation(const TargetPose& pose) {
  for (const auto& mark : pose.marks) {
    if (!near(mark.p_C) || !near(mark.normal_C)) return not_near("a mark's position or normal");
    if (auto why = covariance_violation(mark.covariance, kMaxMarkVariance); !why.empty()) {
      return "mark " + mark.name + ": " + why;
    }
  }
  return {};
}

std::string violation(const ServoGoal& goal) {
  if (goal.kind < ServoGoal::HOLD || goal.kind > ServoGoal::SERVO) return wrong("kind", goal.kind, "0, 1 or 2");
  if (!near(goal.p_TG_C)) return not_near("p_TG_C");
  if (!all_finite({goal.tolerance, goal.speed}) || goal.tolerance < 0.0 || goal.speed < 0.0) {
    return wrong("tolerance or speed", goal.tolerance, "0 or more");
  }
  if (auto why = joints_violation(goal.num_joints, {&goal.position}); !why.empty()) return why;
  return gripper_violation(goal.gripper_opening, goal.gripper_force);
}

std::string violation(const ServoStatus& status) {
  if (!finite(status.error_C)) return not_finite("error_C");
  return covariance_violation(status.covariance, kMaxCovariance);
}

std::string violation(const JointCommand& command) {
  if (auto why = joints_violation(command.num_joints, {&command.position, &command.speed_limit}); !why.empty()) {
    return why;
  }
  for (const double speed : command.speed_limit) {
    if (speed <= 0.0) return wrong("speed_limit", speed, "above 0 rad/s");
  }
  return gripper_violation(command.gripper_opening, command.gripper_force);
}

std::string violation(const JointState& state) {
  if (auto why = joints_violation(state.num_joints, {&state.position, &state.speed}); !why.empty()) return why;
  return gripper_violation(state.gripper_opening, 0.0);
}

std::string violation(const TaskCommand& command) {
  if (command.kind < TaskCommand::START || command.kind > TaskCommand::HOME) {
    return wrong("kind", command.kind, "0, 1 or 2");
  }
  if (!near(command.p_CT_expected)) return not_near("p_CT_expected");
  return pose_violation("drive_pose", command.drive_pose);
}

std::string violation(const SimControl& control) {
  if (control.kind < SimControl::RESET || control.kind > SimControl::STEP) {
    return wrong("kind", control.kind, "0, 1 or 2");
  }
  for (const auto& parameter : control.parameters) {
    if (!std::isfinite(parameter.value)) return not_finite(("parameter " + parameter.name).c_str());
  }
  return {};
}

}  // namespace markservo::bus
