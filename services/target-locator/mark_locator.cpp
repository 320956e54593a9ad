#include "services/target-locator/mark_locator.hpp"

#include <algorithm>
#include <cmath>

#include "services/target-locator/centre/mark_centre.hpp"
#include "services/target-locator/free_surface/point_cloud_centre.hpp"
#include "services/target-locator/image/colour_projection.hpp"
#include "services/target-locator/image/epipolar_rows.hpp"
#include "services/target-locator/image/mask_refinement.hpp"
#include "services/target-locator/plane/shared_visibility.hpp"

namespace markservo::target_locator {
namespace {

constexpr double kLargestSlope = 0.4;  // px of disparity per px that boxes are believed about
constexpr double kHidden = 0.96;       // share of a view's pixels that the other shows, below it something hides some
// What the print at an outline adds to the centre's covariance. Two views show the same print, so that their errors are
// alike and do not average out as errors that count as independent do.
constexpr double kOneViewDoubt = 1.32;
constexpr double kTwoViewsDoubt = 2.0;
constexpr int kSmallestPatch = 8;    // patch px along each axis
constexpr double kFarthest = 1e4;    // m along each axis: nothing a robot sees is farther, and no message says so
constexpr double kLeastKnown = 4e5;  // m^2, of a coordinate: likewise

bool usable(const View& view) {
  const PatchFrame& frame = view.patch.frame;
  return !view.patch.empty() && view.patch.width >= kSmallestPatch && view.patch.height >= kSmallestPatch &&
         frame.scale > 0.0 && std::isfinite(frame.x) && std::isfinite(frame.y) && view.width > 0.0 && view.height > 0.0;
}

// Could the two boxes be one mark's? Rows must overlap, sizes be of one order, and the mark lie in front.
bool boxes_agree(const MarkObservation& observation, const geometry::StereoCamera& camera) {
  const View& left = observation.left;
  const View& right = observation.right;
  const double height = std::max(left.height, right.height);
  if (std::min(left.height, right.height) < 0.4 * height) return false;
  if (std::min(left.width, right.width) < 0.4 * std::max(left.width, right.width)) return false;
  if (std::abs(left.centre_v() - right.centre_v()) > 0.5 * height) return false;
  return (left.centre_u() - camera.cx_left) - (right.centre_u() - camera.cx_right) > 0.0;
}

// Everything both methods need of one mark.
void prepare(const MarkObservation& observation, const LocatorParameters& parameters, LocatorWorkspace& work) {
  const Patch& left = observation.left.patch;
  const Patch& right = observation.right.patch;
  prepare_masks(left, work.left);
  prepare_masks(right, work.right);
  work.left_colours = mark_colours(left, work.left);
  const ColourMap axis = texture_axis(work.left_colours.inside);
  StereoPatch& patch = work.patch;
  project_colours(left, axis, patch.left);
  project_colours(right, axis, patch.right);
  patch.left_frame = left.frame;
  patch.right_frame = right.frame;
  sobel_gradients(patch.left, false, patch.left_gradients);
  align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, 0.0, patch.right_rows);
  foerstner(patch.left_gradients, parameters.features.trace_floor, work.measures);
  find_features(work.measures, work.left.inner, parameters.features, work.features);
}

DisparityPlane plane_of_boxes(const View& left, const View& right) {
  DisparityPlane plane;
  plane.u0 = left.centre_u();
  plane.v0 = left.centre_v();
  plane.at_centre = left.centre_u() - right.centre_u();
  plane.along_u = std::clamp(1.0 - right.width / left.width, -kLargestSlope, kLargestSlope);
  return plane;
}

// How far beyond chance the features lie off the plane: 1 when their own sigmas explain it.
double plane_misfit(std::vector<double> squared_scores) {
  if (squared_scores.empty()) return 1.0;
  const auto middle = squared_scores.begin() + static_cast<std::ptrdiff_t>(squared_scores.size() / 2);
  std::nth_element(squared_scores.begin(), middle, squared_scores.end());
  constexpr double kMedianOfChiSquare = 0.455;
  // Below 4 the features' own sigmas may simply be a little small.
  return std::max(1.0, *middle / kMedianOfChiSquare / 4.0);
}

// The centre in one image, from the outline if it is whole, else from the mask; with what is missing in its covariance.
struct SeenCentre {
  ImageCentre centre;
  bool outlined = false;
};
std::optional<SeenCentre> image_centre(const View& view, const Mask& mask, const MarkColours& colours,
                                       const DisparityPlane& plane, const geometry::StereoCamera& camera,
                                       CameraSide side, double size, const LocatorParameters& parameters,
                                       PlaneImage& contrast_plane) {
  const Patch& patch = view.patch;
  const double disparity = plane.at(plane.u0, plane.v0) - (camera.cx_left - camera.cx_right);
  const double extent = size > 0.0 ? size * disparity / camera.baseline : 0.5 * (view.width + view.height);  // px
  double missing = 0.0;  // of the square's edge, relative
  std::optional<SquareOutline> outline;
  const Contrast contrast = mark_contrast(colours);
  if (contrast.valid) {
    project_colours(patch, contrast.map, contrast_plane);
    outline = fit_square(contrast_plane, mask, patch.frame, parameters.outline);
  }
  std::optional<ImageCentre> centre;
  if (outline) {
    centre = ImageCentre{outline->centre, kTwoViewsDoubt * outline->covariance};
    SquareOutline in_left = *outline;
    if (side == CameraSide::kRight) {
      for (auto& corner : in_left.corners) corner.x() += plane.at(corner.x(), corner.y()) / (1.0 - plane.along_u);
    }
    const auto lengths = side_lengths(in_left, plane, camera);
    if (!lengths) return std::nullopt;
    const double expected = size > 0.0 ? size : lengths->mean();
    missing = (*lengths / expected - Eigen::Vector4d::Ones()).cwiseAbs().maxCoeff();
    if (missing <= parameters.size_tolerance) return SeenCentre{*centre, true};
  } else {
    centre = centre_of_mask(mask, patch.frame, plane, camera, side);
    if (!centre) return std::nullopt;
    const auto area = area_on_plane(mask, patch.frame, plane, camera, side);
    constexpr double kUnknownSize = 0.1;
    missing = size > 0.0 && area ? std::abs(1.0 - std::sqrt(*area) / size) : kUnknownSize;
  }
  // A hidden strip shifts the centre by half its width.
  centre->covariance += Eigen::Matrix2d::Identity() * std::pow(0.5 * missing * extent, 2);
  return SeenCentre{*centre, false};
}

// The mark's centre from what both images show of it. `alike`: the masks say that the right view shows as much of the
// mark as the left one, and in the same place.
std::optional<CentreEstimate> mark_centre(const MarkObservation& observation, bool alike,
                                          const PlaneAlignment& alignment, const geometry::StereoCamera& camera,
                                          const LocatorParameters& parameters, LocatorWorkspace& work) {
  const DisparityPlane& plane = alignment.plane;
  const auto left = image_centre(observation.left, work.left.mask, work.left_colours, plane, camera, CameraSide::kLeft,
                                 observation.size, parameters, work.contrast);
  if (observation.size > 0.0 && left && left->outlined && alike) {
    // The right outline would tell nothing new, for it shows the same print.
    const double share = kOneViewDoubt / kTwoViewsDoubt;
    return fuse_centres(ImageCentre{left->centre.position, share * left->centre.covariance}, std::nullopt, alignment,
                        camera);
  }
  const MarkColours right_colours = mark_colours(observation.right.patch, work.right);
  const auto right = image_centre(observation.right, work.right.mask, right_colours, plane, camera, CameraSide::kRight,
                                  observation.size, parameters, work.contrast);
  const bool whole = left && right && left->outlined && right->outlined;
  if (observation.size > 0.0 && !whole) {
    const Mask left_mask = half_covered(observation.left.patch, work.left.mask, parameters.mask_refinement);
    const Mask right_mask = half_covered(observation.right.patch, work.right.mask, parameters.mask_refinement);
    const auto hidden =
        centre_of_hidden_square({left_mask, work.patch.left_frame}, {right_mask, work.patch.right_frame}, plane,
                                alignment.row_offset, camera, observation.size, parameters.hidden_sides);
    if (hidden) return fuse_centres(hidden, std::nullopt, alignment, camera);
  }
  const auto centre_of = [](const std::optional<SeenCentre>& seen) {
    return seen ? std::make_optional(seen->centre) : std::nullopt;
  };
  return fuse_centres(centre_of(left), centre_of(right), alignment, camera);
}

// Where the direct alignment begins. The masks tell the plane to a pixel or so unless one of them is partly hidden;
// then the boxes and a wide search do.
PlaneSeed find_seed(const MarkObservation& observation, LocatorWorkspace& work, const LocatorParameters& parameters) {
  constexpr double kNear = 2.0;   // px either way
  constexpr double kAlike = 0.8;  // correlation that needs no further search
  const StereoPatch& patch = work.patch;
  PlaneTemplates& pixels = work.pixels;
  PlaneSeed best;
  const auto of_masks = plane_of_masks(work.left.mask, patch.left_frame, work.right.mask, patch.right_frame);
  if (of_masks) best = seed_plane(patch, pixels, *of_masks, kNear, parameters.seed);
  if (best.correlation >= kAlike) return best;
  const double reach = 0.25 * std::max(observation.left.width, observation.right.width);
  const auto consider = [&](const DisparityPlane& guess) {
    const PlaneSeed seed = seed_plane(patch, pixels, guess, reach, parameters.seed);
    if (seed.correlation > best.correlation) best = seed;
  };
  if (of_masks) consider(*of_masks);
  const DisparityPlane of_boxes = plane_of_boxes(observation.left, observation.right);
  consider(of_boxes);
  // What hides one view more than the other makes slopes of its own.
  consider({of_boxes.u0, of_boxes.v0, of_boxes.at_centre, 0.0, 0.0});
  return best;
}

Location locate_plane(const MarkObservation& observation, const geometry::StereoCamera& camera,
                      const LocatorParameters& parameters, LocatorWorkspace& work) {
  Location location;
  location.status = Status::kTooFewMatches;
  if (static_cast<int>(work.features.size()) < parameters.min_matches) return location;
  StereoPatch& patch = work.patch;
  Mask& inside = work.left.inner;
  make_template(patch, inside, parameters.alignment.max_rough_pixels, work.pixels.rough);
  const PlaneSeed seed = find_seed(observation, work, parameters);
  seen_by_both(inside, patch.left_frame, work.right.inner, patch.right_frame, seed.plane, work.common);
  const bool all_in_common = static_cast<double>(work.common.count()) >= kHidden * static_cast<double>(inside.count());
  if (!all_in_common) {
    std::swap(inside, work.common);
    keep_within(inside, work.features);
    make_template(patch, inside, parameters.alignment.max_rough_pixels, work.pixels.rough);
  }
  make_template(patch, inside, parameters.alignment.max_pixels, work.pixels.all);
  auto alignment = align_plane(patch, work.pixels, seed.plane, parameters.alignment);
  constexpr double kWorthResampling = 0.2;  // px of row offset beyond which its linear model is poor
  if (alignment && std::abs(alignment->row_offset) > kWorthResampling &&
      std::abs(alignment->row_offset) <= parameters.max_row_offset) {
    const double offset = alignment->row_offset;
    align_rows(patch.right, patch.right_frame, patch.left_frame, patch.left.height, offset, patch.right_rows);
    alignment = align_plane(patch, inside, alignment->plane, parameters.alignment);
    if (alignment) alignment->row_offset += offset;
  }
  if (!alignment || std::sqrt(alignment->covariance(0, 0)) > parameters.max_centre_sigma) return location;
  if (alignment->correlation < parameters.min_correlation ||
      std::abs(alignment->row_offset) > parameters.max_row_offset) {
    location.status = Status::kInconsistent;
    return location;
  }

  const DisparityPlane& plane = alignment->plane;
  std::vector<double> squared_scores;
  squared_scores.reserve(work.features.size());
  location.matches.reserve(work.features.size());
  for (const Feature& feature : work.features) {
    const double u = patch.left_frame.u_of(feature.column);
    const double v = patch.left_frame.v_of(feature.row);
    const double on_plane = plane.at(u, v);
    const auto match =
        refine_match(patch, feature, {on_plane, plane.along_u, plane.along_v}, &inside, parameters.verification);
    if (!match) continue;
    const double residual = std::abs(match->local.disparity - on_plane);
    squared_scores.push_back(residual * residual / std::max(1e-6, match->sigma * match->sigma));
    if (residual > parameters.max_plane_distance * patch.left_frame.scale) continue;
    location.matches.push_back({u, v, u - match->local.disparity, v + alignment->row_offset, residual});
  }
  const auto found = static_cast<int>(location.matches.size());
  if (found < parameters.min_matches) {
    const bool contradict = static_cast<int>(squared_scores.size()) >= 2 * parameters.min_matches;
    location.status = contradict ? Status::kInconsistent : Status::kTooFewMatches;
    return location;
  }
  if (found < parameters.min_agreeing * static_cast<double>(work.features.size())) {
    location.status = Status::kInconsistent;
    return location;
  }
  alignment->covariance *= plane_misfit(std::move(squared_scores));

  constexpr double kNear = 1.0;  // px of disparity between masks and print
  const bool alike = all_in_common && std::abs(seed.plane.at(plane.u0, plane.v0) - plane.at_centre) <= kNear;
  const auto centre = mark_centre(observation, alike, *alignment, camera, parameters, work);
  if (!centre) {
    location.status = Status::kInconsistent;
    return location;
  }
  location.status = Status::kLocated;
  location.p_C = centre->p_C;
  location.covariance = centre->covariance;
  location.normal_C = plane_normal(plane, camera);
  return location;
}

Location locate_free(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters, const LocatorWorkspace& work) {
  Location location;
  SearchParameters search = parameters.search;
  if (!(search.disparity_min < search.disparity_max)) {
    const double middle = observation.left.centre_u() - observation.right.centre_u();
    const double reach = 0.5 * std::max(observation.left.width, observation.right.width);
    search.disparity_min = std::max(middle - reach, camera.cx_left - camera.cx_right + 1.0);
    search.disparity_max = middle + reach;
  }
  for (const Feature& feature : work.features) {
    const auto rough = search_match(work.patch, feature, search);
    if (!rough) continue;
    const auto match = refine_match(work.patch, feature, {*rough, 0.0, 0.0}, nullptr, parameters.free_refinement);
    if (!match) continue;
    const double u = work.patch.left_frame.u_of(feature.column);
    const double v = work.patch.left_frame.v_of(feature.row);
    location.matches.push_back({u, v, u - match->local.disparity, v, match->sigma});
  }
  const auto centre = centre_of_points(location.matches, camera);
  location.status = Status::kTooFewMatches;
  if (!centre || static_cast<int>(location.matches.size()) < parameters.min_matches) return location;
  location.status = Status::kLocated;
  location.p_C = centre->p_C;
  location.covariance = centre->covariance;
  return location;
}

Location locate_as_in_the_paper(const MarkObservation& observation, const geometry::StereoCamera& camera,
                                const LocatorParameters& parameters, const LocatorWorkspace& work) {
  Location location;
  const Gradients right = sobel_gradients(work.patch.right);
  location.matches = match_as_in_the_paper(work.features, work.patch.left_gradients, right, observation.left,
                                           observation.right, parameters.paper);
  const PaperPosition position = position_as_in_the_paper(location.matches, camera);
  location.status = Status::kTooFewMatches;
  if (position.num_points < parameters.min_matches) return location;
  location.status = Status::kLocated;
  location.p_C = position.p_C;
  location.covariance = position.covariance;
  return location;
}

// Numbers as a real mark can have them; those of a camera or a box beyond all measure end elsewhere.
bool possible(const Location& location) {
  const auto& p_C = location.p_C;
  const Eigen::Array3d variances = location.covariance.diagonal();
  return p_C.allFinite() && p_C.y() > 0.0 && p_C.cwiseAbs().maxCoeff() <= kFarthest &&
         location.covariance.allFinite() && variances.minCoeff() > 0.0 && variances.maxCoeff() <= kLeastKnown &&
         location.normal_C.allFinite();
}

}  // namespace

bool valid_camera(const geometry::StereoCamera& camera) {
  return std::isfinite(camera.fx) && std::isfinite(camera.fy) && std::isfinite(camera.cx_left) &&
         std::isfinite(camera.cx_right) && std::isfinite(camera.cy) && std::isfinite(camera.baseline) &&
         camera.fx > 0.0 && camera.fy > 0.0 && camera.baseline > 0.0;
}

Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters) {
  LocatorWorkspace work;
  return locate_mark(observation, camera, parameters, work);
}

Location locate_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters, LocatorWorkspace& work) {
  Location location;
  const View& left = observation.left;
  const View& right = observation.right;
  if (!left.seen && !right.seen) return location;
  location.status = Status::kSeenByOne;
  if (!left.seen || !right.seen) return location;
  const bool clipped = left.clipped || right.clipped;
  location.status = clipped ? Status::kClipped : Status::kTooFewMatches;
  if (!usable(left) || !usable(right) || !valid_camera(camera)) return location;
  // A clipped mark's boxes and sizes say little, so they are not held against it.
  if (!clipped && !boxes_agree(observation, camera)) {
    location.status = Status::kInconsistent;
    return location;
  }
  prepare(observation, parameters, work);
  if (parameters.method == Method::kPaper) {
    location = locate_as_in_the_paper(observation, camera, parameters, work);
  } else if (observation.surface == Surface::kFree) {
    location = locate_free(observation, camera, parameters, work);
  } else {
    location = locate_plane(observation, camera, parameters, work);
  }
  if (location.status == Status::kLocated && !possible(location)) location.status = Status::kInconsistent;
  if (clipped) location.status = Status::kClipped;
  if (location.status != Status::kLocated) {
    location.p_C.setZero();
    location.covariance.setZero();
    location.normal_C.setZero();
  }
  return location;
}

}  // namespace markservo::target_locator
