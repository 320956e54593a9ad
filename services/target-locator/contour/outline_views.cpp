#include "services/target-locator/contour/outline_views.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "services/target-locator/contour/ellipse_contour.hpp"
#include "services/target-locator/contour/quad_contour.hpp"
#include "services/target-locator/image/mask_moments.hpp"
#include "services/target-locator/outline/moment_square.hpp"

namespace markservo::target_locator {
namespace {

using Vector8 = Eigen::Matrix<double, 8, 1>;
using Matrix8 = Eigen::Matrix<double, 8, 8>;

std::optional<Vector8> corner_values(const QuadContour& contour) {
  const auto corners = contour.corners();
  if (!corners) return std::nullopt;
  Vector8 values;
  for (std::size_t k = 0; k < 4; ++k) values.segment<2>(static_cast<Eigen::Index>(2 * k)) = (*corners)[k];
  return values;
}

// How the corners move with the sides.
std::optional<Matrix8> corner_jacobian(const QuadContour& contour) {
  constexpr double kStep = 1e-4;  // px, and px per px
  Matrix8 jacobian;
  for (int k = 0; k < QuadContour::kSize; ++k) {
    QuadContour moved = contour;
    moved.change(kStep * QuadContour::Vector::Unit(k));
    const auto ahead = corner_values(moved);
    moved.change(-2.0 * kStep * QuadContour::Vector::Unit(k));
    const auto behind = corner_values(moved);
    if (!ahead || !behind) return std::nullopt;
    jacobian.col(k) = (*ahead - *behind) / (2.0 * kStep);
  }
  return jacobian;
}

// In `colours`, which are the patch's.
std::optional<ContrastView> contrast_of(const Patch& patch, const MarkMasks& masks, MarkColours colours) {
  constexpr std::int64_t kHardlyAny = 16;  // pixels: of a small mark nothing is well inside
  if (colours.inside.count < kHardlyAny) {
    colours.inside = {};
    imaging::add_colours(patch.bgr, std::ptrdiff_t{3} * patch.width, masks.mask, 1, colours.inside);
  }
  const Contrast contrast = mark_contrast(colours);
  if (!contrast.valid) return std::nullopt;
  ContrastView view{masks.mask, patch.frame, {}};
  project_colours(patch, contrast.map, view.contrast);
  return view;
}

}  // namespace

std::optional<ContrastViews> contrast_views(const MarkObservation& observation, MarkImages& images) {
  auto left = contrast_of(observation.left.patch, images.left, images.left_colours);
  if (!left) return std::nullopt;
  const Patch& of_right = observation.right.patch;
  auto right = contrast_of(of_right, images.right, mark_colours(of_right, images.right));
  if (!right) return std::nullopt;
  return ContrastViews{std::move(*left), std::move(*right)};
}

std::optional<OutlineInView> quadrangle_of(const ContrastView& view, const OutlineViewParameters& parameters) {
  const auto lines = lines_from_moments(view.mask, parameters.min_squareness);
  const auto start = lines ? QuadContour::from_lines(*lines) : std::nullopt;
  if (!start) return std::nullopt;
  const auto fitted = fit_contour(view.contrast, *start, parameters.fit);
  if (!fitted) return std::nullopt;
  const auto values = corner_values(fitted->shape);
  const auto jacobian = corner_jacobian(fitted->shape);
  if (!values || !jacobian) return std::nullopt;
  OutlineInView outline;
  outline.values = *values;
  for (Eigen::Index k = 0; k < 4; ++k) {
    outline.values[2 * k] = view.frame.u_of((*values)[2 * k]);
    outline.values[2 * k + 1] = view.frame.v_of((*values)[2 * k + 1]);
  }
  outline.rough = fitted->roughness > 1.0;
  outline.covariance = view.frame.scale * view.frame.scale * *jacobian * fitted->covariance * jacobian->transpose();
  return outline;
}

OutlineInView in_order_of(const OutlineInView& left, const OutlineInView& right) {
  const auto corners = [](const OutlineInView& outline) {
    return Eigen::Map<const Eigen::Matrix<double, 2, 4>>(outline.values.data());
  };
  const Eigen::Matrix<double, 2, 4> a = corners(left).colwise() - corners(left).rowwise().mean();
  const Eigen::Matrix<double, 2, 4> b = corners(right).colwise() - corners(right).rowwise().mean();
  int best_turn = 0;
  double best = std::numeric_limits<double>::infinity();
  for (int turn = 0; turn < 4; ++turn) {
    double apart = 0.0;
    for (int k = 0; k < 4; ++k) apart += (a.col(k) - b.col((k + turn) % 4)).squaredNorm();
    if (apart < best) {
      best = apart;
      best_turn = turn;
    }
  }
  OutlineInView ordered = right;
  for (int i = 0; i < 8; ++i) {
    const int from = (i + 2 * best_turn) % 8;
    ordered.values[i] = right.values[from];
    for (int k = 0; k < 8; ++k) ordered.covariance(i, k) = right.covariance(from, (k + 2 * best_turn) % 8);
  }
  return ordered;
}

std::optional<OutlineInView> ellipse_of(const ContrastView& view, const OutlineViewParameters& parameters) {
  const MaskMoments m = moments_of(view.mask);
  if (!(m.n > 0.0)) return std::nullopt;
  constexpr double kOfEllipse = 4.0;  // its M over the second moments of its area
  Eigen::Matrix2d shape;
  shape << m.xx, m.xy, m.xy, m.yy;
  const auto fitted = fit_contour(view.contrast, EllipseContour(m.centre, kOfEllipse * shape), parameters.fit);
  if (!fitted) return std::nullopt;
  const EllipseContour::Vector& p = fitted->shape.parameters();
  const double scale = view.frame.scale;
  EllipseContour::Vector units;
  units << scale, scale, scale * scale, scale * scale, scale * scale;
  OutlineInView outline;
  outline.values = units.cwiseProduct(p);
  outline.values[0] = view.frame.u_of(p[0]);
  outline.values[1] = view.frame.v_of(p[1]);
  outline.rough = fitted->roughness > 1.0;
  outline.covariance = units.asDiagonal() * fitted->covariance * units.asDiagonal();
  return outline;
}

}  // namespace markservo::target_locator
