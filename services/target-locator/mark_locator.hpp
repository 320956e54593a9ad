#pragma once

// From two views of a mark to its centre in space: the whole chain of the paper's section 3, and ours.

#include "common/geometry/stereo_camera.hpp"
#include "services/target-locator/centre/flat_mark_centre.hpp"
#include "services/target-locator/contour/colour_centroid.hpp"
#include "services/target-locator/contour/outline_method.hpp"
#include "services/target-locator/features/features.hpp"
#include "services/target-locator/free_surface/free_surface.hpp"
#include "services/target-locator/location.hpp"
#include "services/target-locator/locator_workspace.hpp"
#include "services/target-locator/mark_observation.hpp"
#include "services/target-locator/paper/paper_matching.hpp"
#include "services/target-locator/plane/mark_plane.hpp"
#include "services/target-locator/plausibility.hpp"

namespace markservo::target_locator {

enum class Method {
  kPaper,    // features, gradient argmin, mean of the points: sections 3.1 and 3.2 literally
  kRefined,  // plane: direct alignment and square outline; free: individual matches with checks
};

struct LocatorParameters {
  Method method = Method::kRefined;
  int min_matches = 6;  // fewer do not carry a position
  FeatureParameters features;
  PlaneParameters plane;    // flat marks
  CentreParameters centre;  // flat marks
  FreeSurfaceParameters free_surface;
  OutlineMethodParameters outline;    // where texture does not suffice
  ColourCentroidParameters centroid;  // where nothing else tells
  double weak_texture_px = 0.05;      // of disparity: sigma of the texture's plane beyond which the outline is asked
  double texture_spread = 0.5;        // of a mark's own extent, that its features have where it is textured all over
  double plain_texture = 0.06;        // of the mark's contrast: texture below it cannot contradict the outline
  PaperParameters paper;
};

// Locates one mark. `camera` must hold finite, positive fx, fy and baseline (valid_camera). Never throws on what a view
// contains; what it cannot use ends in a status.
Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters);

// The same in memory that is kept from mark to mark.
Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters, LocatorWorkspace& work);

}  // namespace markservo::target_locator
