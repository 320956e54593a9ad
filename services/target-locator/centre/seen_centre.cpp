#include "services/target-locator/centre/seen_centre.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "services/target-locator/centre/mask_centre.hpp"

namespace markservo::target_locator {
namespace {

std::optional<SquareOutline> outline_of(const CentreView& seen, const OutlineParameters& parameters,
                                        PlaneImage& contrast_plane) {
  const Contrast contrast = mark_contrast(seen.colours);
  if (!contrast.valid) return std::nullopt;
  project_colours(seen.view.patch, contrast.map, contrast_plane);
  return fit_square(contrast_plane, seen.mask, seen.view.patch.frame, parameters);
}

// What is missing of the square's edge, relative, by the outline's sides; where the size is not known, by how they
// differ.
std::optional<double> missing_of(SquareOutline outline, CameraSide side, const DisparityPlane& plane,
                                 const geometry::StereoCamera& camera, double size) {
  if (side == CameraSide::kRight) {
    for (auto& corner : outline.corners) corner.x() += plane.at(corner.x(), corner.y()) / (1.0 - plane.along_u);
  }
  const auto lengths = side_lengths(outline, plane, camera);
  if (!lengths) return std::nullopt;
  const double expected = size > 0.0 ? size : lengths->mean();
  return (*lengths / expected - Eigen::Vector4d::Ones()).cwiseAbs().maxCoeff();
}

}  // namespace

std::optional<SeenCentre> seen_centre(const CentreView& seen, const DisparityPlane& plane,
                                      const geometry::StereoCamera& camera, double size,
                                      const SeenCentreParameters& parameters, PlaneImage& contrast) {
  const PatchFrame& frame = seen.view.patch.frame;
  ImageCentre centre;
  double missing = 0.0;  // of the square's edge, relative
  if (const auto outline = outline_of(seen, parameters.outline, contrast)) {
    centre = {outline->centre, parameters.print_doubt * outline->covariance};
    const auto of_outline = missing_of(*outline, seen.side, plane, camera, size);
    if (!of_outline) return std::nullopt;
    missing = *of_outline;
    if (missing <= parameters.size_tolerance) return SeenCentre{centre, true};
  } else {
    const auto of_mask = centre_of_mask(seen.mask, frame, plane, camera, seen.side);
    if (!of_mask) return std::nullopt;
    centre = *of_mask;
    const auto area = area_on_plane(seen.mask, frame, plane, camera, seen.side);
    missing = size > 0.0 && area ? std::abs(1.0 - std::sqrt(*area) / size) : parameters.unknown_missing;
  }
  // A hidden strip shifts the centre by half its width.
  const double disparity = plane.at(plane.u0, plane.v0) - (camera.cx_left - camera.cx_right);
  const double extent =
      size > 0.0 ? size * disparity / camera.baseline : 0.5 * (seen.view.width + seen.view.height);  // px
  centre.covariance += Eigen::Matrix2d::Identity() * std::pow(0.5 * missing * extent, 2);
  return SeenCentre{centre, false};
}

std::optional<Eigen::Vector4d> side_lengths(const SquareOutline& outline, const DisparityPlane& plane,
                                            const geometry::StereoCamera& camera) {
  std::array<Eigen::Vector3d, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& image = outline.corners[k];
    const auto p_C = geometry::triangulate(camera, {image.x(), image.y(), image.x() - plane.at(image.x(), image.y())});
    if (!p_C) return std::nullopt;
    corners[k] = *p_C;
  }
  Eigen::Vector4d lengths;
  for (std::size_t k = 0; k < 4; ++k) lengths[static_cast<int>(k)] = (corners[(k + 1) % 4] - corners[k]).norm();
  return lengths;
}

}  // namespace markservo::target_locator
