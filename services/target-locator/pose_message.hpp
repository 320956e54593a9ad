#pragma once

// Between messages and the locator's own structs.

#include <markservo/MarkDetection.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <string>

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

// A TARGET_POSE is one network packet.
inline constexpr int kMaxPoseBytes = 1400;

geometry::StereoCamera camera_of(const StereoCalibration& calibration);

// What robot.yaml or --surface says of a mark.
struct KnownMark {
  Surface surface = Surface::kPlane;
  Outline outline = Outline::kSquare;
  double size = 0.0;  // m; 0: unknown
};

// Points into `mark`'s patches, so `mark` must outlive it. `mark` must have passed the bus's checks.
MarkObservation observation_of(const DetectedMark& mark, const KnownMark& known);

LocatedMark located_mark(const DetectedMark& mark, const Location& location);

MarkMatches matches_of(const DetectedMark& mark, const Location& location);

// An answer to `detection` without marks; session and seq are the publisher's to fill.
template <class M>
M answer_to(const MarkDetection& detection) {
  M message{};
  message.utime = detection.frame_utime;
  message.frame_session = detection.frame_session;
  message.frame_seq = detection.frame_seq;
  message.frame_utime = detection.frame_utime;
  return message;
}

// Takes the last marks off until the message fits one packet. Returns how many were taken.
int fit_into_packet(TargetPose& pose);

}  // namespace markservo::target_locator
