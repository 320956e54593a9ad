#include "services/target-locator/centre/mask_centre.hpp"

#include <cmath>

namespace markservo::target_locator {
namespace {

// What a mask's centroid is uncertain by: its outline is known to half a pixel, and opposite sides may err alike.
constexpr double kMaskCentreSigma = 0.3;  // patch px

// Sums over the mask with weights Z^3, Z in units of fx * baseline (1 / disparity).
struct MaskSums {
  double weight = 0.0;
  // Of weight * Z; the centre in space is the mean of Z times the ray, its image that over the mean Z.
  double depth = 0.0;
  double u = 0.0;  // of weight * Z * u
  double v = 0.0;  // of weight * Z * v
};

std::optional<MaskSums> sum_over_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                      const geometry::StereoCamera& camera, CameraSide side) {
  const double shift = camera.cx_left - camera.cx_right;
  // A right pixel's disparity is the plane's at u_left = u_right + disparity, solved for the disparity.
  const double stretch = side == CameraSide::kLeft ? 1.0 : 1.0 / (1.0 - plane.along_u);
  MaskSums sums;
  for (int y = 0; y < mask.height(); ++y) {
    if (mask.surely_empty(y)) continue;
    const double v = frame.v_of(y);
    for (int x = mask.next(y, 0, true); x < mask.width(); x = mask.next(y, x + 1, true)) {
      const double u = frame.u_of(x);
      const double disparity = plane.at(u, v) * stretch - shift;
      if (!(disparity > 0.0)) return std::nullopt;
      const double depth = 1.0 / disparity;
      const double weight = depth * depth * depth;
      sums.weight += weight;
      sums.depth += weight * depth;
      sums.u += weight * depth * u;
      sums.v += weight * depth * v;
    }
  }
  if (!(sums.weight > 0.0)) return std::nullopt;
  return sums;
}

}  // namespace

std::optional<ImageCentre> centre_of_mask(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                          const geometry::StereoCamera& camera, CameraSide side) {
  const auto sums = sum_over_mask(mask, frame, plane, camera, side);
  if (!sums) return std::nullopt;
  ImageCentre centre;
  centre.position << sums->u / sums->depth, sums->v / sums->depth;
  centre.covariance = Eigen::Matrix2d::Identity() * std::pow(kMaskCentreSigma * frame.scale, 2);
  return centre;
}

std::optional<double> area_on_plane(const Mask& mask, const PatchFrame& frame, const DisparityPlane& plane,
                                    const geometry::StereoCamera& camera, CameraSide side) {
  const auto sums = sum_over_mask(mask, frame, plane, camera, side);
  if (!sums) return std::nullopt;
  // A pixel covers Z^3 / (fx fy c) of the plane n . p = c, with Z = fx B / disparity.
  const Eigen::Vector3d away = disparity_normal(plane, camera);
  const double distance = camera.fx * camera.baseline / away.norm();
  const double unit = std::pow(camera.fx * camera.baseline, 3);
  return sums->weight * unit * frame.scale * frame.scale / (camera.fx * camera.fy * distance);
}

}  // namespace markservo::target_locator
