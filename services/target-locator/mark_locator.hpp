#pragma once

// From two views of a mark to its centre in space: the whole chain of the paper's section 3, and ours.

#include "services/target-locator/features/features.hpp"
#include "services/target-locator/free_surface/patch_matching.hpp"
#include "services/target-locator/hidden/hidden_sides.hpp"
#include "services/target-locator/image/mask_refinement.hpp"
#include "services/target-locator/locator_workspace.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/matching/refinement.hpp"
#include "services/target-locator/outline/square_outline.hpp"
#include "services/target-locator/paper/paper_matching.hpp"
#include "services/target-locator/plane/plane_alignment.hpp"
#include "services/target-locator/plane/plane_seed.hpp"

namespace markservo::target_locator {

enum class Method {
  kPaper,    // features, gradient argmin, mean of the points: sections 3.1 and 3.2 literally
  kRefined,  // plane: direct alignment and square outline; free: individual matches with checks
};

struct LocatorParameters {
  Method method = Method::kRefined;
  FeatureParameters features;
  SeedParameters seed;
  AlignmentParameters alignment;
  RefinementParameters verification = {7, false, 3, 0.25, 1.0, 0.6};  // of a plane's features, from where it says
  OutlineParameters outline;
  HiddenSidesParameters hidden_sides;
  MaskRefinementParameters mask_refinement;  // for marks of which something is hidden
  PaperParameters paper;
  SearchParameters search;  // free surfaces; its disparities are replaced by the boxes' where min >= max
  RefinementParameters free_refinement = {5, true, 8, 0.005, 0.7, 0.85};

  int min_matches = 6;               // fewer do not carry a position
  double min_agreeing = 0.5;         // share of the found features that lie on the plane
  double max_plane_distance = 0.35;  // px, of a feature that lies on the plane
  double min_correlation = 0.5;      // of the views of one mark, on its plane
  double max_row_offset = 3.0;       // px: rows are epipolar lines
  double max_centre_sigma = 0.3;     // px of disparity: with less texture the depth is a guess
  double size_tolerance = 0.04;      // relative, of the square's sides before it counts as not seen whole
};

// Locates one mark. `camera` must hold finite, positive fx, fy and baseline (valid_camera). Never throws on what a view
// contains; what it cannot use ends in a status.
Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters);

// The same in memory that is kept from mark to mark.
Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters, LocatorWorkspace& work);

// Finite everywhere, fx, fy and baseline above 0.
bool valid_camera(const geometry::StereoCamera& camera);

}  // namespace markservo::target_locator
