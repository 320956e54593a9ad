#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "services/target-locator/contour/shared_outline.hpp"

namespace markservo::target_locator {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr Index kUnknowns = 8;  // the centre, a small turn, half the edge, the row offset
constexpr Index kCorners = 4;
constexpr double kStep_px = 1e-3;

Vector2d corner(const VectorXd& values, Index k) {
  return values.segment<2>(2 * ((k + kCorners) % kCorners));
}

// A square in space.
struct Square {
  Vector3d p_C = Vector3d::Zero();       // m, its centre
  Matrix3d axes = Matrix3d::Identity();  // columns: along the first side, along the second one, their cross product
  double half = 0.0;                     // m, of its edge

  Square changed(const VectorXd& unknowns) const {
    const Vector3d turn = unknowns.segment<3>(3);
    const double angle = turn.norm();
    const Vector3d about = angle > 0.0 ? Vector3d(turn / angle) : Vector3d::UnitX();
    return {p_C + unknowns.head<3>(), Eigen::AngleAxisd(angle, about) * axes, half + unknowns[6]};
  }

  Vector3d corner_C(Index k) const {
    const double along = k == 0 || k == 3 ? -half : half;
    const double across = k < 2 ? -half : half;
    return p_C + along * axes.col(0) + across * axes.col(1);
  }
};

// The square whose corners are nearest those that the views show, about.
std::optional<Square> rough_square(const SharedOutlineInput& input) {
  std::array<Vector3d, kCorners> corners;
  for (Index k = 0; k < kCorners; ++k) {
    const Vector2d left = corner(input.left.values, k);
    const auto p_C = geometry::triangulate(input.camera, {left.x(), left.y(), corner(input.right.values, k).x()});
    if (!p_C) return std::nullopt;
    corners[static_cast<std::size_t>(k)] = *p_C;
  }
  Square square;
  square.p_C = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const Vector3d along = 0.5 * (corners[1] - corners[0] + corners[2] - corners[3]);
  const Vector3d across = 0.5 * (corners[3] - corners[0] + corners[2] - corners[1]);
  square.half = 0.25 * (along.norm() + across.norm());
  const Vector3d normal = along.cross(across);
  if (!(normal.norm() > 0.0)) return std::nullopt;
  square.axes.col(0) = along.normalized();
  square.axes.col(2) = normal.normalized();
  square.axes.col(1) = square.axes.col(2).cross(square.axes.col(0));
  return square;
}

// The disparities of a plane through `p_C` (fx baseline n . ray / n . p_C).
std::optional<DisparityPlane> plane_through(const Vector3d& p_C, const Vector3d& normal,
                                            const geometry::StereoCamera& camera) {
  const double distance = normal.dot(p_C);
  if (!(std::abs(distance) > 0.0)) return std::nullopt;
  const Vector3d per_ray = camera.fx * camera.baseline / distance * normal;
  return DisparityPlane{camera.cx_left, camera.cy, per_ray.y() + camera.cx_left - camera.cx_right,
                        per_ray.x() / camera.fx, -per_ray.z() / camera.fy};
}

std::optional<OutlinePrediction> prediction_of(const Square& square, double row_offset,
                                               const geometry::StereoCamera& camera) {
  OutlinePrediction predicted;
  predicted.left.resize(2 * kCorners);
  predicted.right.resize(2 * kCorners);
  predicted.row_offset = row_offset;
  for (Index k = 0; k < kCorners; ++k) {
    const auto seen = geometry::project(camera, square.corner_C(k));
    if (!seen) return std::nullopt;
    predicted.left.segment<2>(2 * k) << seen->u_left, seen->v;
    predicted.right.segment<2>(2 * k) << seen->u_right, seen->v + row_offset;
  }
  const auto plane = plane_through(square.p_C, square.axes.col(2), camera);
  if (!plane) return std::nullopt;
  predicted.plane = *plane;
  return predicted;
}

// Side k lies between the corners k and k + 1. Where it lies further out than it is seen, these move along the sides
// that it meets: the ways that they go, in one view.
struct SideEnds {
  Vector2d first;
  Vector2d second;

  SideEnds(const VectorXd& values, Index k)
      : first((corner(values, k) - corner(values, k - 1)).normalized()),
        second((corner(values, k + 1) - corner(values, k + 2)).normalized()) {}
};

// The view without what it tells of side k.
OutlineInView without_side(const OutlineInView& view, Index k) {
  const SideEnds out(view.values, k);
  VectorXd first = VectorXd::Zero(2 * kCorners);
  VectorXd second = VectorXd::Zero(2 * kCorners);
  first.segment<2>(2 * k) = out.first;
  second.segment<2>(2 * ((k + 1) % kCorners)) = out.second;
  const double anywhere_2 = (corner(view.values, k + 2) - corner(view.values, k)).squaredNorm();
  OutlineInView without = view;
  without.covariance += anywhere_2 * (first * first.transpose() + second * second.transpose());
  return without;
}

// How far the square's side k lies beyond the one that is seen, over the square's edge.
double hidden_share(const VectorXd& seen, const VectorXd& predicted, Index k) {
  const SideEnds out(seen, k);
  const double beyond = 0.5 * ((corner(predicted, k) - corner(seen, k)).dot(out.first) +
                               (corner(predicted, k + 1) - corner(seen, k + 1)).dot(out.second));
  const double edge = 0.5 * ((corner(predicted, k) - corner(predicted, k - 1)).norm() +
                             (corner(predicted, k + 1) - corner(predicted, k + 2)).norm());
  return beyond / edge;
}

// A square that all sides fit, or all but one.
struct Candidate {
  Square square;
  double row_offset = 0.0;
  Matrix3d covariance;  // m^2, of the centre
  Misfit misfit;
};

std::optional<Candidate> fit(const SharedOutlineInput& input, const Square& start, double left_out,
                             const SharedOutlineParameters& parameters) {
  LeastSquaresProblem problem = measured_by(input, parameters.row_offset_sigma);
  problem.predict = [&](const VectorXd& unknowns) -> std::optional<VectorXd> {
    const auto predicted = prediction_of(start.changed(unknowns), unknowns[7], input.camera);
    return predicted ? std::make_optional(stacked(*predicted, input.texture)) : std::nullopt;
  };
  const double step_m = kStep_px * start.p_C.y() / input.camera.fx;
  problem.start = VectorXd::Zero(kUnknowns);
  problem.step = VectorXd::Constant(kUnknowns, step_m);
  problem.step.segment<3>(3).setConstant(step_m / start.half);
  problem.step[7] = kStep_px;
  const auto solution = solve_least_squares(problem);
  if (!solution) return std::nullopt;
  const Misfit misfit(solution->chi_square, solution->degrees_of_freedom - left_out, input.rough());
  return Candidate{start.changed(solution->unknowns), solution->unknowns[7],
                   misfit.growth * solution->covariance.topLeftCorner<3, 3>(), misfit};
}

// The squares of which one side is hidden in part, in either view as may be.
std::vector<Candidate> with_a_hidden_side(const SharedOutlineInput& input, const Square& start,
                                          const SharedOutlineParameters& parameters) {
  constexpr double kOfTwoSides = 4.0;  // measurements: place and turn, in two views
  std::vector<Candidate> candidates;
  for (Index k = 0; k < kCorners; ++k) {
    const SharedOutlineInput rest{without_side(input.left, k), without_side(input.right, k), input.camera,
                                  input.texture};
    const auto candidate = fit(rest, start, kOfTwoSides, parameters);
    if (!candidate) continue;
    const auto predicted = prediction_of(candidate->square, candidate->row_offset, input.camera);
    if (!predicted) continue;
    const double of_left = hidden_share(input.left.values, predicted->left, k);
    const double of_right = hidden_share(input.right.values, predicted->right, k);
    if (!(of_left + of_right > 0.0) || !(std::max(of_left, of_right) <= parameters.most_hidden)) continue;
    candidates.push_back(*candidate);
  }
  return candidates;
}

OutlineEstimate estimate_of(const Candidate& candidate, const geometry::StereoCamera& camera) {
  OutlineEstimate estimate;
  const Square& square = candidate.square;
  estimate.p_C = square.p_C;
  estimate.covariance = candidate.covariance;
  const Vector3d normal = square.axes.col(2);
  estimate.normal_C = normal.dot(square.p_C) > 0.0 ? Vector3d(-normal) : normal;
  const auto predicted = prediction_of(square, candidate.row_offset, camera);
  for (Index k = 0; predicted && k < kCorners; ++k) {
    const Vector2d left = corner(predicted->left, k);
    const Vector2d right = corner(predicted->right, k);
    estimate.matches.push_back({left.x(), left.y(), right.x(), right.y(), 0.0});
  }
  return estimate;
}

// Without those that are much less likely than the likeliest, which comes first.
void keep_likely(std::vector<Candidate>& candidates, const SharedOutlineParameters& parameters) {
  if (candidates.empty()) return;
  const auto by_chi_square = [](const Candidate& a, const Candidate& b) {
    return a.misfit.chi_square < b.misfit.chi_square;
  };
  std::sort(candidates.begin(), candidates.end(), by_chi_square);
  const Misfit best = candidates.front().misfit;
  const double limit = best.chi_square + parameters.as_likely * best.growth;
  const auto unlikely = [&](const Candidate& candidate) { return candidate.misfit.chi_square > limit; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), unlikely), candidates.end());
}

// How far the candidates lie from a point: the mean square.
Matrix3d spread_about(const Vector3d& p_C, const std::vector<Candidate>& candidates) {
  Matrix3d spread = Matrix3d::Zero();
  for (const Candidate& candidate : candidates) {
    const Vector3d off = candidate.square.p_C - p_C;
    spread += off * off.transpose() / static_cast<double>(candidates.size());
  }
  return spread;
}

// The middle of the candidates, and all of their places as its doubt. Nothing where none fits.
std::optional<OutlineEstimate> mean_of(const std::vector<Candidate>& candidates, const geometry::StereoCamera& camera,
                                       const SharedOutlineParameters& parameters) {
  if (candidates.empty() || !(candidates.front().misfit.excess <= parameters.max_excess)) return std::nullopt;
  OutlineEstimate estimate = estimate_of(candidates.front(), camera);
  estimate.p_C.setZero();
  estimate.covariance.setZero();
  const double share = 1.0 / static_cast<double>(candidates.size());
  for (const Candidate& candidate : candidates) {
    estimate.p_C += share * candidate.square.p_C;
    estimate.covariance += share * candidate.covariance;
  }
  estimate.covariance += spread_about(estimate.p_C, candidates);
  return estimate;
}

}  // namespace

std::optional<OutlineEstimate> square_from_outlines(const SharedOutlineInput& given,
                                                    const SharedOutlineParameters& parameters) {
  const SharedOutlineInput input{with_floor(given.left, kCorners, parameters.floor_px),
                                 with_floor(given.right, kCorners, parameters.floor_px), given.camera, given.texture};
  const auto start = rough_square(input);
  if (!start) return std::nullopt;
  const auto whole = fit(input, *start, 0.0, parameters);
  const bool fits = whole && whole->misfit.excess <= parameters.max_excess;
  if (fits && whole->misfit.excess <= 1.0) return estimate_of(*whole, input.camera);
  std::vector<Candidate> candidates = with_a_hidden_side(input, *start, parameters);
  keep_likely(candidates, parameters);
  if (!fits) return mean_of(candidates, input.camera, parameters);
  // So little may as well be what edges and packing leave: the place stands, but a side may be hidden.
  OutlineEstimate estimate = estimate_of(*whole, input.camera);
  estimate.covariance += spread_about(estimate.p_C, candidates);
  return estimate;
}

}  // namespace markservo::target_locator
