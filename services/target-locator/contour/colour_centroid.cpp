#include "services/target-locator/contour/colour_centroid.hpp"

#include <algorithm>
#include <cmath>

#include "services/target-locator/image/mask_moments.hpp"

namespace markservo::target_locator {
namespace {

struct Centroid {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // px of the image
  double variance = 0.0;                               // px^2, along either axis
  double area = 0.0;                                   // px^2
};

// Of contrast, which is 1 in the mark and 0 around it: its first moments over the mark and its blurred edge.
std::optional<Centroid> centroid_of(const ContrastView& view, const MarkMasks& masks, double floor_px) {
  double sum = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double squares = 0.0;
  double around = 0.0;
  double noise = 0.0;
  double second = 0.0;
  const double x0 = 0.5 * view.contrast.width;
  const double y0 = 0.5 * view.contrast.height;
  for (int y = 0; y < masks.reach.height(); ++y) {
    const float* row = view.contrast.row(y);
    for (int x = masks.reach.next(y, 0, true); x < masks.reach.width(); x = masks.reach.next(y, x + 1, true)) {
      const double value = row[x];
      if (masks.ring.test(x, y)) {
        around += 1.0;
        noise += value * value;
        continue;
      }
      sum += value;
      sum_x += value * (x - x0);
      sum_y += value * (y - y0);
      squares += 1.0;
      second += 0.5 * ((x - x0) * (x - x0) + (y - y0) * (y - y0));
    }
  }
  if (!(sum > 0.5) || !(around > 0.0)) return std::nullopt;
  Centroid centroid;
  const Eigen::Vector2d middle(sum_x / sum, sum_y / sum);
  centroid.position << view.frame.u_of(x0 + middle.x()), view.frame.v_of(y0 + middle.y());
  const double spread = std::max(1.0, second - 0.5 * squares * middle.squaredNorm());
  const double scale_2 = view.frame.scale * view.frame.scale;
  centroid.variance = scale_2 * (noise / around * spread / (sum * sum) + floor_px * floor_px);
  centroid.area = scale_2 * sum;
  return centroid;
}

// How narrow a mask is: its least extent over its largest, [0, 1].
double narrowness(const Mask& mask) {
  const MaskMoments moments = moments_of(mask);
  const double middle = 0.5 * (moments.xx + moments.yy);
  const double half = std::hypot(0.5 * (moments.xx - moments.yy), moments.xy);
  return middle + half > 0.0 ? std::sqrt(std::max(0.0, middle - half) / (middle + half)) : 0.0;
}

// Of the mark's edge, relative: what the area lacks, or may lack. What is slanted or hidden is narrower by as much: a
// narrow thing of the right area is another one.
double missing_of(const MarkObservation& observation, double area, double narrow, double disparity,
                  const geometry::StereoCamera& camera, double unknown) {
  const bool any_shape = observation.surface == Surface::kFree ||
                         (observation.surface == Surface::kPlane && observation.outline == Outline::kOther);
  if (any_shape || !(observation.size > 0.0)) return unknown;
  const bool square = observation.surface == Surface::kPlane && observation.outline == Outline::kSquare;
  const double edge = observation.size * disparity / camera.baseline;  // px
  const double expected = (square ? 1.0 : M_PI / 4.0) * edge * edge;
  return std::max(std::abs(1.0 - std::sqrt(area / expected)), 1.0 - std::sqrt(narrow));
}

}  // namespace

std::optional<OutlineEstimate> locate_by_centroid(const MarkObservation& observation,
                                                  const geometry::StereoCamera& camera,
                                                  const ColourCentroidParameters& parameters, const MarkImages& images,
                                                  const ContrastViews& views) {
  const auto l = centroid_of(views.left, images.left, parameters.floor_px);
  const auto r = centroid_of(views.right, images.right, parameters.floor_px);
  if (!l || !r) return std::nullopt;
  const geometry::StereoPoint point{l->position.x(), 0.5 * (l->position.y() + r->position.y()), r->position.x()};
  const auto p_C = geometry::triangulate(camera, point);
  if (!p_C) return std::nullopt;
  const double area = 0.5 * (l->area + r->area);
  const double narrow = std::min(narrowness(images.left.mask), narrowness(images.right.mask));
  const double missing =
      missing_of(observation, area, narrow, camera.disparity(point), camera, parameters.unknown_missing);
  if (!(missing <= parameters.most_missing)) return std::nullopt;
  // A hidden strip shifts a view's middle by half its width.
  const double hidden = std::pow(0.5 * missing, 2) * area;
  // And a slanted or round thing's middle is not the middle of its image, by as much as its nearest and farthest points
  // differ in size to second order.
  const double perspective = std::pow(camera.disparity(point) * area / (4.0 * camera.fx * camera.fx), 2);
  // Of either view; half of it shifts both alike, so that the disparity has as much of it as a view.
  const double shift = hidden + perspective;
  Eigen::Matrix3d image = Eigen::Matrix3d::Zero();  // px^2, of (u_left, v, disparity)
  image(0, 0) = l->variance + shift;
  image(1, 1) = 0.25 * (l->variance + r->variance) + shift;  // the mean of two
  image(2, 2) = l->variance + r->variance + shift;
  image(0, 2) = image(2, 0) = l->variance + 0.5 * shift;
  const Eigen::Matrix3d jacobian = geometry::triangulation_jacobian(camera, point);
  OutlineEstimate estimate;
  estimate.p_C = *p_C;
  estimate.covariance = jacobian * image * jacobian.transpose();
  estimate.matches.push_back({point.u_left, l->position.y(), point.u_right, r->position.y(), 0.0});
  return estimate;
}

}  // namespace markservo::target_locator
