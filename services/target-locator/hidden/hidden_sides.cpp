#include "services/target-locator/hidden/hidden_sides.hpp"

#include <cmath>

#include "services/target-locator/hidden/axis_evidence.hpp"
#include "services/target-locator/hidden/plane_axes.hpp"
#include "services/target-locator/hidden/square_turn.hpp"

namespace markservo::target_locator {
namespace {

// Rows or columns of patch pixels, the fewer, that a line of `extent` (m, on the plane) crosses.
double pixel_crossings(const PlaneAxes& axes, const Eigen::Vector2d& extent, double scale) {
  const auto from = axes.image(Eigen::Vector2d::Zero());
  const auto to = axes.image(extent);
  return from && to ? (*to - *from).cwiseAbs().minCoeff() / scale : 0.0;
}

// The place on the plane as the left image shows it; `step`: m, over which the plane's map to the image is linear.
std::optional<ImageCentre> image_of(const PlaneAxes& axes, const Eigen::Vector2d& place,
                                    const Eigen::Matrix2d& covariance, double step) {
  const auto position = axes.image(place);
  if (!position) return std::nullopt;
  Eigen::Matrix2d jacobian;
  for (int k = 0; k < 2; ++k) {
    const auto moved = axes.image(place + step * Eigen::Vector2d::Unit(k));
    if (!moved) return std::nullopt;
    jacobian.col(k) = (*moved - *position) / step;
  }
  return ImageCentre{*position, jacobian * covariance * jacobian.transpose()};
}

}  // namespace

std::optional<ImageCentre> centre_of_hidden_square(const MaskedView& left, const MaskedView& right,
                                                   const DisparityPlane& plane, double row_offset,
                                                   const geometry::StereoCamera& camera, double size,
                                                   const HiddenSidesParameters& parameters) {
  const PlaneAxes axes(plane, camera);
  if (!(axes.depth() > parameters.least_gap)) return std::nullopt;
  const auto outlines = outlines_on_plane(left, right, axes, plane, row_offset, camera.fx);
  if (!outlines) return std::nullopt;
  const auto rough_turn = best_turn(*outlines, (1.0 + parameters.most_too_large) * size + outlines->pixel);
  if (!rough_turn) return std::nullopt;
  const double turn = aligned_turn(*outlines, aligned_turn(*outlines, *rough_turn));
  const double separation = camera.baseline * parameters.least_gap / (axes.depth() - parameters.least_gap);
  const Eigen::Vector2d first(std::cos(turn), std::sin(turn));
  const Eigen::Vector2d second(-first.y(), first.x());
  const auto along_axis = [&](const Eigen::Vector2d& axis) {
    const double crossings = pixel_crossings(axes, Eigen::Vector2d(-axis.y(), axis.x()) * size, left.frame.scale);
    return AxisEvidence(*outlines, axis, separation, crossings, size, parameters).centre();
  };
  const auto along_first = along_axis(first);
  const auto along_second = along_axis(second);
  if (!along_first || !along_second) return std::nullopt;
  const Eigen::Vector2d place = along_first->mean * first + along_second->mean * second;
  const Eigen::Matrix2d covariance =
      along_first->variance * first * first.transpose() + along_second->variance * second * second.transpose();
  return image_of(axes, place, covariance, outlines->pixel);
}

}  // namespace markservo::target_locator
