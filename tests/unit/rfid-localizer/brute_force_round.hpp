#pragma once

// The product of a Gaussian with a round's outcomes by plain summation over a fine grid: slow, and written without a
// look at the service's own.

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "services/rfid-localizer/round_match.hpp"

namespace markservo::rfid_localizer::test {

struct GaussianPlace {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  double evidence = 0.0;
};

struct Footprint {
  double radius = 0.1;     // m
  double softness = 0.01;  // m
  double false_read = 1e-4;

  double operator()(const Eigen::Vector2d& p, const Eigen::Vector2d& tag) const {
    return 1.0 / (1.0 + std::exp(((p - tag).norm() - radius) / softness));
  }
};

// The grid has a spacing of `step` (m) and covers `reach` (m) around the prior's mean.
inline GaussianPlace brute_force(const Eigen::Vector2d& mean, const Eigen::Matrix2d& covariance,
                                 const std::vector<TagOutcome>& outcomes, const std::vector<WindowPoint>& window,
                                 const Footprint& footprint, double reach, double step) {
  const Eigen::Matrix2d information = covariance.inverse();
  const int steps = static_cast<int>(std::ceil(reach / step));
  double prior_sum = 0.0;
  double sum = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Eigen::Vector2d d(i * step, j * step);
      const double prior = std::exp(-0.5 * d.dot(information * d));
      prior_sum += prior;
      if (prior < 1e-12) continue;
      double likelihood = 1.0;
      for (const TagOutcome& tag : outcomes) {
        double answers = 0.0;
        if (tag.read && tag.moment_known) {
          answers = footprint(mean + d + tag.offset, tag.p_W);
        } else {
          for (const WindowPoint& point : window) answers += point.weight * footprint(mean + d + point.offset, tag.p_W);
        }
        answers *= tag.reliability;
        likelihood *= tag.read ? answers + footprint.false_read : 1.0 - answers;
      }
      sum += prior * likelihood;
      first += prior * likelihood * d;
      second += prior * likelihood * d * d.transpose();
    }
  }
  GaussianPlace result;
  result.mean = mean + first / sum;
  result.covariance = second / sum - (first / sum) * (first / sum).transpose();
  result.evidence = sum / prior_sum;
  return result;
}

// First two moments of all parts together.
inline GaussianPlace whole(const RoundMatch& match) {
  GaussianPlace all;
  all.evidence = match.evidence;
  for (const PlacePart& part : match.parts) all.mean += part.share * part.mean;
  for (const PlacePart& part : match.parts) {
    const Eigen::Vector2d d = part.mean - all.mean;
    all.covariance += part.share * (part.covariance + d * d.transpose());
  }
  return all;
}

}  // namespace markservo::rfid_localizer::test
