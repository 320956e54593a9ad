#include "services/rfid-localizer/round_match.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace markservo::rfid_localizer {
namespace {

// The prior's ellipse: p = mean + axes * u, u in standard deviations.
struct Ellipse {
  Eigen::Vector2d mean;
  Eigen::Matrix2d axes;
};

// Points evenly spaced in u around `centre`.
struct Grid {
  Eigen::Vector2d centre;  // of u
  Eigen::Vector2d half;    // half extent of u
  int points = 0;
};

struct Sums {
  double prior = 0.0;
  double posterior = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // of u - centre
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  std::vector<double> inside;
};

double footprint(const Eigen::Vector2d& p, const TagOutcome& tag, const std::vector<WindowPoint>& window,
                 const ReadModel& model) {
  if (tag.read && tag.moment_known) return model.inside((p + tag.offset - tag.p_W).squaredNorm());
  double sum = 0.0;
  for (const WindowPoint& point : window) {
    sum += point.weight * model.inside((p + point.offset - tag.p_W).squaredNorm());
  }
  return sum;
}

Sums integrate(const Ellipse& ellipse, const Grid& grid, const std::vector<TagOutcome>& outcomes,
               const std::vector<WindowPoint>& window, const ReadModel& model, double false_read) {
  Sums sums;
  sums.inside.assign(outcomes.size(), 0.0);
  std::vector<double> inside(outcomes.size());
  const Eigen::Vector2d step = 2.0 * grid.half / (grid.points - 1);
  for (int i = 0; i < grid.points; ++i) {
    for (int j = 0; j < grid.points; ++j) {
      const Eigen::Vector2d offset = -grid.half + step.cwiseProduct(Eigen::Vector2d(i, j));
      const Eigen::Vector2d u = grid.centre + offset;
      const Eigen::Vector2d p = ellipse.mean + ellipse.axes * u;
      const double prior = std::exp(-0.5 * u.squaredNorm());
      double likelihood = 1.0;
      for (std::size_t k = 0; k < outcomes.size(); ++k) {
        inside[k] = footprint(p, outcomes[k], window, model);
        const double reading = outcomes[k].reliability * inside[k];
        likelihood *= outcomes[k].read ? reading + false_read : 1.0 - reading;
      }
      const double weight = prior * likelihood;
      sums.prior += prior;
      sums.posterior += weight;
      sums.first += weight * offset;
      sums.second += weight * offset * offset.transpose();
      for (std::size_t k = 0; k < inside.size(); ++k) sums.inside[k] += weight * inside[k];
    }
  }
  return sums;
}

Eigen::Matrix2d spread(const Sums& sums) {
  const Eigen::Vector2d mean = sums.first / sums.posterior;
  return sums.second / sums.posterior - mean * mean.transpose();
}

}  // namespace

std::vector<WindowPoint> window_points(const Eigen::Vector2d& way) {
  constexpr double kStanding = 0.002;  // m
  if (way.norm() < kStanding) return {{Eigen::Vector2d::Zero(), 1.0}};
  // Gauss-Legendre of three points, over half the way to either side.
  const Eigen::Vector2d node = std::sqrt(0.6) * 0.5 * way;
  return {{-node, 5.0 / 18.0}, {Eigen::Vector2d::Zero(), 8.0 / 18.0}, {node, 5.0 / 18.0}};
}

RoundMatch match_round(const Eigen::Vector2d& prior_mean, const Eigen::Matrix2d& prior_covariance,
                       const std::vector<TagOutcome>& outcomes, const std::vector<WindowPoint>& window,
                       const ReadModel& model, const RoundMatchParameters& parameters) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(prior_covariance);
  const Eigen::Vector2d sigmas = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  const Ellipse ellipse{prior_mean, solver.eigenvectors() * sigmas.asDiagonal()};

  // No wider than the edge is soft, or the grid would step over what the tags say.
  const double extent = 2.0 * parameters.span * sigmas.maxCoeff();
  const int wanted = static_cast<int>(std::ceil(std::min(extent / model.softness(), 1e3))) + 1;
  Grid grid{Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant(parameters.span),
            std::clamp(wanted, parameters.least_points, parameters.most_points)};
  Sums sums = integrate(ellipse, grid, outcomes, window, model, parameters.false_read);
  RoundMatch match;
  if (!(sums.posterior > 0.0) || !(sums.prior > 0.0)) {  // everything contradicts everything
    match.mean = prior_mean;
    match.covariance = prior_covariance;
    match.inside.assign(outcomes.size(), 0.0);
    return match;
  }
  match.evidence = sums.posterior / sums.prior;

  // Far narrower than the grid: once more, where it lies.
  const Eigen::Vector2d narrow = spread(sums).diagonal().cwiseMax(0.0).cwiseSqrt();
  constexpr double kNarrow = 0.4;  // standard deviations of the prior
  constexpr double kMargin = 4.0;  // standard deviations of what was found
  if (narrow.minCoeff() < kNarrow || grid.points == parameters.most_points) {
    const double spacing = 2.0 * grid.half.x() / (grid.points - 1);
    grid.centre += sums.first / sums.posterior;
    grid.half = (kMargin * narrow).array() + spacing;
    Sums finer = integrate(ellipse, grid, outcomes, window, model, parameters.false_read);
    if (finer.posterior > 0.0) sums = std::move(finer);
  }
  match.mean = ellipse.mean + ellipse.axes * (grid.centre + sums.first / sums.posterior);
  match.covariance = ellipse.axes * spread(sums) * ellipse.axes.transpose();
  for (double& inside : sums.inside) inside /= sums.posterior;
  match.inside = std::move(sums.inside);
  return match;
}

}  // namespace markservo::rfid_localizer
