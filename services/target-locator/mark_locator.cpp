#include "services/target-locator/mark_locator.hpp"

#include <utility>

#include "services/target-locator/paper/paper_method.hpp"

namespace markservo::target_locator {
namespace {

Location locate_flat_mark(const MarkObservation& observation, const geometry::StereoCamera& camera,
                          const LocatorParameters& parameters, LocatorWorkspace& work) {
  MarkPlane plane =
      measure_plane(observation, parameters.plane, parameters.min_matches, work.images, work.features, work.plane);
  Location location;
  location.status = plane.status;
  location.matches = std::move(plane.matches);
  if (plane.status != Status::kLocated) return location;
  const auto centre = flat_mark_centre(observation, plane, camera, parameters.centre, work.images, work.contrast);
  if (!centre) {
    location.status = Status::kInconsistent;
    return location;
  }
  location.p_C = centre->p_C;
  location.covariance = centre->covariance;
  location.normal_C = plane_normal(plane.alignment.plane, camera);
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
    return locate_as_in_the_paper(observation, camera, parameters.paper, parameters.min_matches, patch, work.features);
  }
  if (observation.surface == Surface::kFree) {
    return locate_free_surface(observation, camera, parameters.free_surface, parameters.min_matches, patch,
                               work.features);
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
  }
  return location;
}

}  // namespace markservo::target_locator
