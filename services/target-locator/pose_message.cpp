#include "services/target-locator/pose_message.hpp"

#include "common/messages/state_codes.hpp"

namespace markservo::target_locator {
namespace {

View view_of(const MarkView& message) {
  View view;
  view.seen = message.seen != 0;
  view.clipped = message.clipped != 0;
  view.x = message.x;
  view.y = message.y;
  view.width = message.width;
  view.height = message.height;
  const MarkPatch& patch = message.patch;
  if (patch.scale > 0) {
    view.patch.frame = {static_cast<double>(patch.x), static_cast<double>(patch.y), static_cast<double>(patch.scale)};
    view.patch.width = patch.width;
    view.patch.height = patch.height;
    view.patch.bgr = patch.bgr.data();
    view.patch.mask = patch.mask.data();
  }
  return view;
}

Vector3 message_of(const Eigen::Vector3d& v) {
  Vector3 message{};
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

}  // namespace

geometry::StereoCamera camera_of(const StereoCalibration& c) {
  return {c.fx, c.fy, c.cx_left, c.cx_right, c.cy, c.baseline};
}

MarkObservation observation_of(const DetectedMark& mark, const KnownMark& known) {
  MarkObservation observation;
  observation.left = view_of(mark.left);
  observation.right = view_of(mark.right);
  observation.surface = known.surface;
  observation.outline = known.outline;
  observation.size = known.size;
  return observation;
}

LocatedMark located_mark(const DetectedMark& mark, const Location& location) {
  LocatedMark message{};
  message.name = mark.name;
  message.role = mark.role;
  message.status = messages::code_of(location.status);
  message.cue = messages::code_of(location.cue);
  message.p_C = message_of(location.p_C);
  message.covariance.xx = location.covariance(0, 0);
  message.covariance.xy = location.covariance(0, 1);
  message.covariance.xz = location.covariance(0, 2);
  message.covariance.yy = location.covariance(1, 1);
  message.covariance.yz = location.covariance(1, 2);
  message.covariance.zz = location.covariance(2, 2);
  message.normal_C = message_of(location.normal_C);
  message.num_features = location.status == Status::kLocated ? static_cast<std::int32_t>(location.matches.size()) : 0;
  return message;
}

MarkMatches matches_of(const DetectedMark& mark, const Location& location) {
  MarkMatches message{};
  message.name = mark.name;
  message.num_matches = static_cast<std::int32_t>(location.matches.size());
  for (const Match& match : location.matches) {
    message.u_left.push_back(match.u_left);
    message.v_left.push_back(match.v_left);
    message.u_right.push_back(match.u_right);
    message.v_right.push_back(match.v_right);
    message.residual.push_back(match.residual);
  }
  return message;
}

int fit_into_packet(TargetPose& pose) {
  int taken = 0;
  pose.num_marks = static_cast<std::int32_t>(pose.marks.size());
  while (!pose.marks.empty() && pose.getEncodedSize() > kMaxPoseBytes) {
    pose.marks.pop_back();
    pose.num_marks = static_cast<std::int32_t>(pose.marks.size());
    ++taken;
  }
  return taken;
}

}  // namespace markservo::target_locator
