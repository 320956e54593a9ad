#include "services/camera-check/marks/mark_messages.hpp"

#include <string>

#include "common/messages/state_codes.hpp"

namespace markservo::camera_check {
namespace {

// What carried the position: the one place to say it. Today that is always the mark's texture.
std::string cue_of(const LocatedMark& mark) {
  return "texture (" + std::to_string(mark.num_features) + " points)";
}

}  // namespace

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
      placed.cue = cue_of(mark);
      placed.p_C = Eigen::Vector3d(mark.p_C.x, mark.p_C.y, mark.p_C.z);
    }
    sightings.add(placed);
  }
}

}  // namespace markservo::camera_check
