#pragma once

#include <optional>
#include <vector>

#include "services/base-navigator/navigator_types.hpp"

namespace markservo::base_navigator {

struct FlatFaceParameters {
  double spread = 0.03;  // m, by which three neighbours' echoes may disagree: three sigma of a sonar
  double gain = 0.05;    // m, by which an arc may at most be pushed out: what stands before a face by less stays unseen
  double noise = 0.01;   // m, standard deviation of a sonar: by at least so much the gain stays below the clearance
};

// A wall or a shelf's front as a line in R.
struct FlatFace {
  double normal = 0.0;    // rad, direction from R's origin to the line
  double distance = 0.0;  // m, from R's origin
};

// For each reading the flat face that explains it and both its neighbours in the ring, if one does.
//
// Docked before a shelf, the arcs of the sonars beside the front one bend 3 cm nearer to the robot than the shelf is.
std::vector<std::optional<FlatFace>> flat_faces(const FlatFaceParameters& parameters, const SonarScanSample& scan);

// m, the range at which the beam's ray in direction `angle` (rad, from the beam's middle) meets the face, but not below
// the reading's own range nor beyond it by more than the gain.
double range_to_face(const FlatFaceParameters& parameters, const SonarReading& reading, const FlatFace& face,
                     double angle);

}  // namespace markservo::base_navigator
