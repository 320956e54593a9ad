#pragma once

// The plane of a flat mark, from its images and features.

#include <vector>

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/matching/refinement.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"
#include "services/target-locator/plane/plane_seed.hpp"
#include "services/target-locator/plane/plane_template.hpp"

namespace markservo::target_locator {

struct PlaneParameters {
  SeedParameters seed;
  AlignmentParameters alignment;
  RefinementParameters verification = {7, false, 3, 0.25, 1.0, 0.6};  // of the features, from where the plane says
  double whole_share = 0.96;  // of a view's pixels that the other shows, below it something hides some
  AlignmentLimits limits;
  double max_plane_distance = 0.35;  // px, of a feature that lies on the plane
  double min_agreeing = 0.5;         // share of the features that lie on the plane
  double masks_agree_px = 1.0;       // of disparity between masks and print
};

struct MarkPlane {
  Status status = Status::kTooFewMatches;  // kLocated when the plane is measured
  PlaneAlignment alignment;                // valid when it is
  std::vector<Match> matches;              // the features on it, also when they are too few
  // The masks say that the right view shows as much of the mark as the left one, and in the same place.
  bool views_alike = false;
};

// Room that is used again from mark to mark.
struct PlaneWorkspace {
  Mask common;  // what is well inside in both views
  PlaneTemplates pixels;
};

// Measures the plane and holds the features against it, of which `min_matches` must lie on it. Where something hides a
// part of the mark from one camera, features there are taken away. The right view's rows in `images` are aligned anew
// where they turn out to lie off.
MarkPlane measure_plane(const MarkObservation& observation, const PlaneParameters& parameters, int min_matches,
                        MarkImages& images, std::vector<Feature>& features, PlaneWorkspace& work);

}  // namespace markservo::target_locator
