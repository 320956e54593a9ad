#include "services/camera-check/marks/mark_messages.hpp"

#include "common/messages/state_codes.hpp"

namespace markservo::camera_check {

void add_to(MarkSightings& sightings, const MarkDetection& detection) {
  for (const DetectedMark& mark : detection.marks) {
    sightings.add(SeenMark{mark.name, mark.left.seen != 0, mark.right.seen != 0});
  }
}

void add_to(MarkSightings& sightings, const TargetPose& pose) {
  for (const LocatedMark& mark : pose.marks) {
    PlacedMark placed;
    placed.name = mark.name;
    placed.status = messages::state_of<MarkStatus>(mark.status);
    if (placed.status == MarkStatus::kLocated) {
      placed.cue = messages::state_of<MarkCue>(mark.cue);
      placed.num_points = mark.num_features;
      placed.p_C = Eigen::Vector3d(mark.p_C.x, mark.p_C.y, mark.p_C.z);
    }
    sightings.add(placed);
  }
}

}  // namespace markservo::camera_check
