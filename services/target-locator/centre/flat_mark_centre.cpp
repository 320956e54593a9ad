#include "services/target-locator/centre/flat_mark_centre.hpp"

#include "services/target-locator/hidden/hidden_sides.hpp"

namespace markservo::target_locator {
namespace {

std::optional<ImageCentre> centre_of_hidden(const MarkObservation& observation, const PlaneAlignment& alignment,
                                            const geometry::StereoCamera& camera, const CentreParameters& parameters,
                                            const MarkImages& images) {
  const Mask left = half_covered(observation.left.patch, images.left.mask, parameters.mask_refinement);
  const Mask right = half_covered(observation.right.patch, images.right.mask, parameters.mask_refinement);
  return centre_of_hidden_square({left, images.patch.left_frame}, {right, images.patch.right_frame}, alignment.plane,
                                 alignment.row_offset, camera, observation.size, parameters.hidden_sides);
}

std::optional<ImageCentre> centre_of(const std::optional<SeenCentre>& seen) {
  return seen ? std::make_optional(seen->centre) : std::nullopt;
}

}  // namespace

std::optional<CentreEstimate> flat_mark_centre(const MarkObservation& observation, const MarkPlane& plane,
                                               const geometry::StereoCamera& camera, const CentreParameters& parameters,
                                               MarkImages& images, PlaneImage& contrast) {
  const PlaneAlignment& alignment = plane.alignment;
  // Of another shape's size nothing follows for its sides.
  const double size = observation.outline == Outline::kSquare ? observation.size : 0.0;
  const bool known_size = size > 0.0;
  const auto see = [&](const View& view, const Mask& mask, const MarkColours& colours, CameraSide side) {
    return seen_centre({view, mask, colours, side}, alignment.plane, camera, size, parameters.seen, contrast);
  };
  const auto left = see(observation.left, images.left.mask, images.left_colours, CameraSide::kLeft);
  if (known_size && left && left->outlined && plane.views_alike) {
    // The right outline would tell nothing new, for it shows the same print.
    const double share = parameters.one_view_print_doubt / parameters.seen.print_doubt;
    return fuse_centres(ImageCentre{left->centre.position, share * left->centre.covariance}, std::nullopt, alignment,
                        camera);
  }
  const MarkColours right_colours = mark_colours(observation.right.patch, images.right);
  const auto right = see(observation.right, images.right.mask, right_colours, CameraSide::kRight);
  const bool whole = left && right && left->outlined && right->outlined;
  if (known_size && !whole) {
    const auto hidden = centre_of_hidden(observation, alignment, camera, parameters, images);
    if (hidden) return fuse_centres(hidden, std::nullopt, alignment, camera);
  }
  return fuse_centres(centre_of(left), centre_of(right), alignment, camera);
}

}  // namespace markservo::target_locator
