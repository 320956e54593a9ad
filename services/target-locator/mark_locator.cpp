#include "services/target-locator/mark_locator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "services/target-locator/contour/contrast_patch.hpp"
#include "services/target-locator/image/mask_moments.hpp"
#include "services/target-locator/image/texture_strength.hpp"
#include "services/target-locator/paper/paper_method.hpp"

namespace markservo::target_locator {
namespace {

// What the texture alone says of a mark.
struct ByTexture {
  Location location;
  PlaneAlignment plane;   // valid when a plane is located
  bool all_over = false;  // there is texture all over the mark, matched or not
};

// Features enough, and spread as the mark is: those of a highlight or a shadow's border lie together.
bool is_all_over(const std::vector<Feature>& features, const Mask& mask, const LocatorParameters& parameters) {
  if (static_cast<int>(features.size()) < parameters.min_matches) return false;
  const auto n = static_cast<double>(features.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double squares = 0.0;
  for (const Feature& feature : features) {
    const Eigen::Vector2d at(feature.column, feature.row);
    mean += at / n;
    squares += at.squaredNorm() / n;
  }
  const MaskMoments moments = moments_of(mask);
  const double spread_2 = squares - mean.squaredNorm();
  return spread_2 >= std::pow(parameters.texture_spread, 2) * (moments.xx + moments.yy);
}

ByTexture locate_by_texture(const MarkObservation& observation, const geometry::StereoCamera& camera,
                            const LocatorParameters& parameters, LocatorWorkspace& work) {
  ByTexture by_texture;
  by_texture.all_over = is_all_over(work.features, work.images.left.mask, parameters);
  MarkPlane plane =
      measure_plane(observation, parameters.plane, parameters.min_matches, work.images, work.features, work.plane);
  Location& location = by_texture.location;
  location.status = plane.status;
  location.matches = std::move(plane.matches);
  if (plane.status != Status::kLocated) return by_texture;
  by_texture.plane = plane.alignment;
  const auto centre = flat_mark_centre(observation, plane, camera, parameters.centre, work.images, work.contrast);
  if (!centre) {
    location.status = Status::kInconsistent;
    return by_texture;
  }
  location.cue = Cue::kTexture;
  location.p_C = centre->p_C;
  location.covariance = centre->covariance;
  location.normal_C = plane_normal(plane.alignment.plane, camera);
  return by_texture;
}

Location location_of(const OutlineEstimate& estimate, Cue cue) {
  Location location;
  location.status = Status::kLocated;
  location.cue = cue;
  location.p_C = estimate.p_C;
  location.covariance = estimate.covariance;
  location.normal_C = estimate.normal_C;
  location.matches = estimate.matches;
  return location;
}

// There is no texture that could contradict what an outline or a middle says.
bool is_plain(const MarkImages& images, double plain_texture) {
  const imaging::ColourSums& inside = images.left_colours.inside;
  const imaging::ColourSums& around = images.left_colours.around;
  double gap_2 = 0.0;
  // Of a thin mark nothing is well inside, so that no texture is seen either.
  for (int channel = 0; inside.count > 0 && around.count > 0 && channel < 3; ++channel) {
    gap_2 += std::pow(inside.mean(channel) - around.mean(channel), 2);
  }
  return texture_strength(images.patch.left, images.left.inner) <= plain_texture * std::sqrt(gap_2);
}

// Where the texture does not suffice: by the outline, fused with what texture there is, or by the middle of the colour.
Location locate_without_texture(const MarkObservation& observation, const geometry::StereoCamera& camera,
                                const LocatorParameters& parameters, const ByTexture& by_texture,
                                const std::optional<PlaneAlignment>& texture, LocatorWorkspace& work) {
  const bool located = by_texture.location.status == Status::kLocated;
  const auto is_textured = [&] { return !is_plain(work.images, parameters.plain_texture); };
  // Two things of one outline may have different prints: a texture that does not match is not overruled.
  const bool in_question = !located && by_texture.all_over;
  if (in_question && is_textured()) return by_texture.location;
  const auto views = contrast_views(observation, work.images);
  if (!views) return by_texture.location;
  if (observation.surface != Surface::kFree) {
    const auto by_outline = locate_by_outline(observation, camera, parameters.outline, texture, work.images, *views);
    if (by_outline) return location_of(*by_outline, Cue::kOutline);
  }
  if (located || (!in_question && is_textured())) return by_texture.location;
  const auto by_centroid = locate_by_centroid(observation, camera, parameters.centroid, work.images, *views);
  return by_centroid ? location_of(*by_centroid, Cue::kCentroid) : by_texture.location;
}

Location locate_flat_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                          const LocatorParameters& parameters, LocatorWorkspace& work) {
  const ByTexture by_texture = locate_by_texture(observation, camera, parameters, work);
  const bool located = by_texture.location.status == Status::kLocated;
  // Where another shape's middle is only its outline tells.
  if (located && observation.outline == Outline::kSquare &&
      std::sqrt(by_texture.plane.covariance(0, 0)) <= parameters.weak_texture_px) {
    return by_texture.location;
  }
  const auto texture = located ? std::make_optional(by_texture.plane) : std::nullopt;
  return locate_without_texture(observation, camera, parameters, by_texture, texture, work);
}

// The paper's way: by corners of the texture, or, on a mark that has none, by those of its outline.
Location locate_by_corners(const MarkObservation& observation, const geometry::StereoCamera& camera,
                           const LocatorParameters& parameters, LocatorWorkspace& work) {
  const auto enough = static_cast<std::size_t>(std::max(0, parameters.min_matches));
  const auto at_outline = work.features.size() < enough ? contrast_patch(observation, work.images) : std::nullopt;
  if (!at_outline) {
    return locate_as_in_the_paper(observation, camera, parameters.paper, parameters.min_matches, work.images.patch,
                                  work.features);
  }
  Mask about;
  imaging::dilate(work.images.left.mask, parameters.paper.outline_reach, about);
  foerstner(at_outline->left_gradients, parameters.features.trace_floor, work.measures);
  find_features(work.measures, about, parameters.features, work.features);
  Location location = locate_as_in_the_paper(observation, camera, parameters.paper, parameters.paper.min_corners,
                                             *at_outline, work.features);
  if (location.status != Status::kLocated) return location;
  location.cue = Cue::kOutline;
  // Corners on whole pixels may all have the same disparity, so that their scatter says nothing.
  const auto seen = geometry::project(camera, location.p_C);
  if (!seen) return location;
  const Eigen::Matrix3d jacobian = geometry::triangulation_jacobian(camera, *seen);
  constexpr double kRounding = 1.0 / 12.0;  // px^2, of a whole pixel
  const double pixel_2 = kRounding * std::pow(at_outline->left_frame.scale, 2);
  const Eigen::Vector3d variances(pixel_2, pixel_2, 2.0 * pixel_2);
  location.covariance += jacobian * variances.asDiagonal() * jacobian.transpose();
  return location;
}

// Both views must be usable.
Location locate_seen(const MarkObservation& observation, const geometry::StereoCamera& camera,
                     const LocatorParameters& parameters, LocatorWorkspace& work) {
  make_mark_images(observation.left, observation.right, work.images);
  const StereoPatch& patch = work.images.patch;
  foerstner(patch.left_gradients, parameters.features.trace_floor, work.measures);
  find_features(work.measures, work.images.left.inner, parameters.features, work.features);
  if (parameters.method == Method::kPaper) {
    return locate_by_corners(observation, camera, parameters, work);
  }
  if (observation.surface == Surface::kFree) {
    ByTexture by_texture;
    by_texture.location =
        locate_free_surface(observation, camera, parameters.free_surface, parameters.min_matches, patch, work.features);
    if (by_texture.location.status == Status::kLocated) return by_texture.location;
    by_texture.all_over = is_all_over(work.features, work.images.left.mask, parameters);
    return locate_without_texture(observation, camera, parameters, by_texture, std::nullopt, work);
  }
  if (observation.surface == Surface::kBall) {
    ByTexture nothing;
    nothing.location.status = Status::kTooFewMatches;
    return locate_without_texture(observation, camera, parameters, nothing, std::nullopt, work);
  }
  return locate_flat_mark(observation, camera, parameters, work);
}

}  // namespace

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
  if (!is_usable(left) || !is_usable(right) || !valid_camera(camera)) return location;
  // A clipped mark's boxes and sizes say little, so they are not held against it.
  if (!clipped && !boxes_agree(left, right, camera)) {
    location.status = Status::kInconsistent;
    return location;
  }
  location = locate_seen(observation, camera, parameters, work);
  if (location.status == Status::kLocated && !is_possible(location)) location.status = Status::kInconsistent;
  if (clipped) location.status = Status::kClipped;
  if (location.status != Status::kLocated) {
    location.p_C.setZero();
    location.covariance.setZero();
    location.normal_C.setZero();
    location.cue = Cue::kNone;
  }
  return location;
}

}  // namespace markservo::target_locator
