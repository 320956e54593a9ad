#pragma once

// Outlines of a mark in its two views.

#include <optional>
#include <utility>

#include "services/target-locator/contour/contour_fit.hpp"
#include "services/target-locator/contour/shared_outline.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/mark_images.hpp"
#include "services/target-locator/mark_observation.hpp"

namespace markservo::target_locator {

struct OutlineViewParameters {
  double min_squareness = 0.5;  // fourth moment of the mask's shape, 1 for a square, 0 for a disc
  ContourFitParameters fit;
};

// A mark in one image, on the plane that shows its contrast.
struct ContrastView {
  const Mask& mask;
  const PatchFrame& frame;
  PlaneImage contrast;
};

struct ContrastViews {
  ContrastView left;
  ContrastView right;
};

// Both views, each in the colour by which the mark stands out in it. Nothing where mark and surroundings look the same.
// Points into `observation` and `images`, whose rings are made.
std::optional<ContrastViews> contrast_views(const MarkObservation& observation, MarkImages& images);

// The square's corners, column and row of each, px of the image. Nothing when the outline is no quadrangle.
std::optional<OutlineInView> quadrangle_of(const ContrastView& view, const OutlineViewParameters& parameters);

// The right quadrangle's corners in the order of the left one's.
OutlineInView in_order_of(const OutlineInView& left, const OutlineInView& right);

// The parameters of a disc's or ball's ellipse (EllipseContour), px of the image. Nothing when the outline is none.
std::optional<OutlineInView> ellipse_of(const ContrastView& view, const OutlineViewParameters& parameters);

}  // namespace markservo::target_locator
