#include "services/target-locator/contour/outline_method.hpp"

#include "services/target-locator/centre/centre_fusion.hpp"
#include "services/target-locator/centre/mask_centre.hpp"

namespace markservo::target_locator {
namespace {

// The middle of the masks on the plane that the outline or, if it is surer, the texture shows.
std::optional<OutlineEstimate> locate_any_shape(const MarkObservation& observation,
                                                const geometry::StereoCamera& camera,
                                                const OutlineBandParameters& parameters,
                                                const std::optional<PlaneAlignment>& texture,
                                                const MarkImages& images) {
  auto alignment = plane_of_outline(observation, images, parameters);
  if (texture && (!alignment || texture->covariance(0, 0) < alignment->covariance(0, 0))) alignment = texture;
  if (!alignment) return std::nullopt;
  const DisparityPlane& plane = alignment->plane;
  const auto left = centre_of_mask(images.left.mask, images.patch.left_frame, plane, camera, CameraSide::kLeft);
  const auto right = centre_of_mask(images.right.mask, images.patch.right_frame, plane, camera, CameraSide::kRight);
  if (!left || !right) return std::nullopt;
  const auto centre = fuse_centres(left, right, *alignment, camera);
  if (!centre) return std::nullopt;
  OutlineEstimate estimate;
  estimate.p_C = centre->p_C;
  estimate.covariance = centre->covariance;
  estimate.normal_C = plane_normal(plane, camera);
  const Eigen::Vector2d& at = left->position;
  estimate.matches.push_back({at.x(), at.y(), at.x() - plane.at(at.x(), at.y()), at.y() + alignment->row_offset, 0.0});
  return estimate;
}

}  // namespace

std::optional<OutlineEstimate> locate_by_outline(const MarkObservation& observation,
                                                 const geometry::StereoCamera& camera,
                                                 const OutlineMethodParameters& parameters,
                                                 const std::optional<PlaneAlignment>& texture, const MarkImages& images,
                                                 const ContrastViews& views) {
  if (observation.surface == Surface::kPlane && observation.outline == Outline::kSquare) {
    const auto of_left = quadrangle_of(views.left, parameters.views);
    const auto of_right = of_left ? quadrangle_of(views.right, parameters.views) : std::nullopt;
    if (!of_right) return std::nullopt;
    return square_from_outlines({*of_left, in_order_of(*of_left, *of_right), camera, texture}, parameters.shared);
  }
  const bool ball = observation.surface == Surface::kBall;
  if (!ball && observation.outline != Outline::kDisc) {
    return locate_any_shape(observation, camera, parameters.band, texture, images);
  }
  const auto of_left = ellipse_of(views.left, parameters.views);
  const auto of_right = of_left ? ellipse_of(views.right, parameters.views) : std::nullopt;
  if (!of_right) return std::nullopt;
  const SharedOutlineInput input{*of_left, *of_right, camera, texture};
  return ball ? ball_from_outlines(input, parameters.shared) : disc_from_outlines(input, parameters.shared);
}

}  // namespace markservo::target_locator
