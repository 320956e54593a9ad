#include "services/target-locator/contour/shared_outline.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "services/target-locator/contour/least_squares.hpp"

namespace markservo::target_locator {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr Index kPlane = 4;  // unknowns behind the outline's: disparity at its middle, along columns, rows; row offset
constexpr double kStep_px = 1e-3;

// The unknowns of an outline on a plane.
struct PlaneUnknowns {
  DisparityPlane plane;
  double row_offset = 0.0;

  PlaneUnknowns(const VectorXd& unknowns, const Vector2d& about) {
    const auto tail = unknowns.tail<kPlane>();
    plane = {about.x(), about.y(), tail[0], tail[1], tail[2]};
    row_offset = tail[3];
  }
};

VectorXd plane_steps(Index shape, double extent, double shape_step) {
  VectorXd step = VectorXd::Constant(shape + kPlane, shape_step);
  step.tail<kPlane>() << kStep_px, kStep_px / extent, kStep_px / extent, kStep_px;
  return step;
}

// An outline on a plane: how the right view's values come of the left one's.
struct PlaneModel {
  std::function<VectorXd(const VectorXd& left, const PlaneUnknowns& unknowns)> right_of;
  Vector2d about;  // px, left view
  double extent;   // px
};

std::optional<LeastSquaresSolution> solve_on_plane(const SharedOutlineInput& input, const PlaneModel& model,
                                                   const Eigen::Vector3d& plane_start, double shape_step,
                                                   const SharedOutlineParameters& parameters) {
  const Index n = input.left.values.size();
  LeastSquaresProblem problem = measured_by(input, parameters.row_offset_sigma);
  problem.predict = [&, n](const VectorXd& unknowns) -> std::optional<VectorXd> {
    const PlaneUnknowns on_plane(unknowns, model.about);
    const VectorXd left = unknowns.head(n);
    return stacked({left, model.right_of(left, on_plane), on_plane.row_offset, on_plane.plane}, input.texture);
  };
  problem.start = VectorXd::Zero(n + kPlane);
  problem.start.head(n) = input.left.values;
  problem.start.segment<3>(n) = plane_start;
  problem.step = plane_steps(n, model.extent, shape_step);
  return solve_least_squares(problem);
}

// A function of the unknowns, with its covariance.
struct Propagated {
  VectorXd value;
  MatrixXd covariance;
};

std::optional<Propagated> propagate(const VectorFunction& function, const LeastSquaresSolution& solution,
                                    const VectorXd& step) {
  const auto value = function(solution.unknowns);
  const auto jacobian = derivatives_of(function, solution.unknowns, step);
  if (!value || !jacobian) return std::nullopt;
  return Propagated{*value, *jacobian * solution.covariance * jacobian->transpose()};
}

// Values that should all be 1 in space, as far as tolerance and noise allow.
bool is_regular(const std::optional<Propagated>& ratios, const SharedOutlineParameters& parameters) {
  if (!ratios) return false;
  for (Index k = 0; k < ratios->value.size(); ++k) {
    const double sigma = std::sqrt(std::max(0.0, ratios->covariance(k, k)));
    if (!(std::abs(ratios->value[k] - 1.0) <= parameters.shape_tolerance + parameters.shape_sigmas * sigma)) {
      return false;
    }
  }
  return true;
}

std::optional<Vector3d> on_plane_in_space(const Vector2d& image, const DisparityPlane& plane,
                                          const geometry::StereoCamera& camera) {
  return geometry::triangulate(camera, {image.x(), image.y(), image.x() - plane.at(image.x(), image.y())});
}

Match match_of(const Vector2d& left, const PlaneUnknowns& on_plane) {
  const double d = on_plane.plane.at(left.x(), left.y());
  return {left.x(), left.y(), left.x() - d, left.y() + on_plane.row_offset, 0.0};
}

// Of the solution and its centre; nothing when the views contradict each other.
std::optional<OutlineEstimate> estimate_of(const LeastSquaresSolution& solution,
                                           const std::optional<Propagated>& centre, bool rough,
                                           const SharedOutlineParameters& parameters) {
  if (!centre) return std::nullopt;
  const Misfit misfit(solution.chi_square, solution.degrees_of_freedom, rough);
  if (!(misfit.excess <= parameters.max_excess)) return std::nullopt;
  OutlineEstimate estimate;
  estimate.p_C = centre->value;
  estimate.covariance = misfit.growth * centre->covariance;
  return estimate;
}

Eigen::Matrix2d shape_of(const VectorXd& values) {
  Eigen::Matrix2d shape;
  shape << values[2], values[3], values[3], values[4];
  return shape;
}

VectorXd ellipse_values(const Vector2d& centre, const Eigen::Matrix2d& shape) {
  VectorXd values(5);
  values << centre.x(), centre.y(), shape(0, 0), shape(0, 1), shape(1, 1);
  return values;
}

VectorXd right_ellipse(const VectorXd& left, const PlaneUnknowns& on_plane) {
  Eigen::Matrix2d map;
  map << 1.0 - on_plane.plane.along_u, -on_plane.plane.along_v, 0.0, 1.0;
  const Vector2d at = left.head<2>();
  const Vector2d centre(at.x() - on_plane.plane.at(at.x(), at.y()), at.y() + on_plane.row_offset);
  return ellipse_values(centre, map * shape_of(left) * map.transpose());
}

// The image of the middle of the circle whose image is the ellipse: the pole of the plane's line at infinity, where the
// disparity is that of infinity.
Vector2d image_of_centre(const VectorXd& ellipse, const DisparityPlane& plane, const geometry::StereoCamera& camera) {
  const Vector2d at = ellipse.head<2>();
  const double ahead = plane.at(at.x(), at.y()) - (camera.cx_left - camera.cx_right);
  return at - shape_of(ellipse) * Vector2d(plane.along_u, plane.along_v) / ahead;
}

constexpr int kPointsAround = 6;

Vector2d point_around(const VectorXd& ellipse, int k) {
  const Eigen::Matrix2d root = shape_of(ellipse).llt().matrixL();
  const double angle = 2.0 * M_PI * k / kPointsAround;
  return ellipse.head<2>() + root * Vector2d(std::cos(angle), std::sin(angle));
}

// Distances of points around from the centre, over their mean.
std::optional<VectorXd> disc_ratios(const VectorXd& unknowns, const Vector2d& about,
                                    const geometry::StereoCamera& camera) {
  const PlaneUnknowns on_plane(unknowns, about);
  const auto centre = on_plane_in_space(image_of_centre(unknowns, on_plane.plane, camera), on_plane.plane, camera);
  if (!centre) return std::nullopt;
  VectorXd ratios(kPointsAround);
  for (int k = 0; k < kPointsAround; ++k) {
    const auto p_C = on_plane_in_space(point_around(unknowns, k), on_plane.plane, camera);
    if (!p_C) return std::nullopt;
    ratios[k] = (*p_C - *centre).norm();
  }
  return VectorXd(ratios / ratios.mean());
}

// The ellipse that a camera at `lens` (m, C) sees of a sphere: the lines of sight r with (r . P)^2 = |r|^2 (|P|^2 -
// radius^2), P from the lens. Nothing when the lens is inside or the outline is no ellipse.
std::optional<VectorXd> image_of_ball(const Vector3d& p_C, double radius, const Vector3d& lens, double fx, double fy,
                                      double cx, double cy) {
  const Vector3d off = p_C - lens;
  const double touching = off.squaredNorm() - radius * radius;
  if (!(touching > 0.0) || !(off.y() > radius)) return std::nullopt;
  const Eigen::Matrix3d cone = off * off.transpose() - touching * Eigen::Matrix3d::Identity();
  Eigen::Matrix3d ray;  // of (u - cx, v - cy, 1)
  ray << 1.0 / fx, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0 / fy, 0.0;
  const Eigen::Matrix3d conic = ray.transpose() * cone * ray;
  const Eigen::Matrix2d a = conic.topLeftCorner<2, 2>();
  const Vector2d b = conic.topRightCorner<2, 1>();
  if (!(a.determinant() > 0.0)) return std::nullopt;
  const Vector2d centre = -a.inverse() * b;
  const double size = -(conic(2, 2) + b.dot(centre));
  return ellipse_values(centre + Vector2d(cx, cy), size * a.inverse());
}

}  // namespace

std::optional<OutlineEstimate> disc_from_outlines(const SharedOutlineInput& given,
                                                  const SharedOutlineParameters& parameters) {
  const SharedOutlineInput input{with_floor(given.left, 1, parameters.floor_px),
                                 with_floor(given.right, 1, parameters.floor_px), given.camera, given.texture};
  const Vector2d about = input.left.values.head<2>();
  const double extent = std::sqrt(input.left.values[2]);
  const PlaneModel model{right_ellipse, about, extent};
  const double disparity = about.x() - input.right.values[0];
  const auto solution = solve_on_plane(input, model, {disparity, 0.0, 0.0}, kStep_px, parameters);
  if (!solution) return std::nullopt;
  const VectorXd step = plane_steps(5, extent, kStep_px);
  const VectorFunction ratios = [&](const VectorXd& unknowns) { return disc_ratios(unknowns, about, input.camera); };
  if (!is_regular(propagate(ratios, *solution, step), parameters)) return std::nullopt;
  const VectorFunction centre = [&](const VectorXd& unknowns) -> std::optional<VectorXd> {
    const PlaneUnknowns on_plane(unknowns, about);
    const auto p_C =
        on_plane_in_space(image_of_centre(unknowns, on_plane.plane, input.camera), on_plane.plane, input.camera);
    return p_C ? std::make_optional<VectorXd>(*p_C) : std::nullopt;
  };
  auto estimate = estimate_of(*solution, propagate(centre, *solution, step), input.rough(), parameters);
  if (!estimate) return std::nullopt;
  const PlaneUnknowns on_plane(solution->unknowns, about);
  estimate->normal_C = plane_normal(on_plane.plane, input.camera);
  for (int k = 0; k < kPointsAround; ++k) {
    estimate->matches.push_back(match_of(point_around(solution->unknowns, k), on_plane));
  }
  return estimate;
}

std::optional<OutlineEstimate> ball_from_outlines(const SharedOutlineInput& given,
                                                  const SharedOutlineParameters& parameters) {
  const OutlineInView left = with_floor(given.left, 1, parameters.floor_px);
  const OutlineInView right = with_floor(given.right, 1, parameters.floor_px);
  const geometry::StereoCamera& camera = given.camera;
  const auto start = geometry::triangulate(camera, {left.values[0], left.values[1], right.values[0]});
  if (!start) return std::nullopt;
  const double radius = std::sqrt(std::max(0.0, left.values[4])) * start->y() / camera.fy;
  LeastSquaresProblem problem = measured_by({left, right, camera, std::nullopt}, parameters.row_offset_sigma);
  problem.predict = [&](const VectorXd& unknowns) -> std::optional<VectorXd> {
    const Vector3d p_C = unknowns.head<3>();
    const auto of_left =
        image_of_ball(p_C, unknowns[3], Vector3d::Zero(), camera.fx, camera.fy, camera.cx_left, camera.cy);
    const auto of_right = image_of_ball(p_C, unknowns[3], {camera.baseline, 0.0, 0.0}, camera.fx, camera.fy,
                                        camera.cx_right, camera.cy + unknowns[4]);
    if (!of_left || !of_right) return std::nullopt;
    return stacked({*of_left, *of_right, unknowns[4], {}}, std::nullopt);
  };
  problem.start = VectorXd::Zero(5);
  problem.start << *start, radius, 0.0;
  const double step_m = kStep_px * start->y() / camera.fx;
  problem.step = VectorXd::Constant(5, step_m);
  problem.step[4] = kStep_px;
  const auto solution = solve_least_squares(problem);
  if (!solution) return std::nullopt;
  const VectorFunction centre = [](const VectorXd& unknowns) -> std::optional<VectorXd> {
    return VectorXd(unknowns.head<3>());
  };
  auto estimate = estimate_of(*solution, propagate(centre, *solution, problem.step), given.rough(), parameters);
  const auto predicted = problem.predict(solution->unknowns);
  if (!estimate || !predicted) return std::nullopt;
  // What both views show of it are different circles: their middles alone belong together.
  estimate->matches.push_back({(*predicted)[0], (*predicted)[1], (*predicted)[5], (*predicted)[6], 0.0});
  return estimate;
}

}  // namespace markservo::target_locator
