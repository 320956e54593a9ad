#pragma once

// What one round of the reader says about where the antenna is, given a Gaussian that says where it should be: the
// moments of the product. A tag that was not read tells as much as one that was.

#include <Eigen/Core>
#include <vector>

#include "services/rfid-localizer/read_model.hpp"

namespace markservo::rfid_localizer {

// One tag near the antenna.
struct TagOutcome {
  Eigen::Vector2d p_W = Eigen::Vector2d::Zero();  // m
  bool read = false;
  double reliability = 1.0;  // read probability well inside the footprint
  // When it was read, as an offset of the antenna from the round's middle; used if `read` and `moment_known`.
  bool moment_known = false;
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();  // m
};

// Where the antenna was at one moment of the round, from where it was in its middle.
struct WindowPoint {
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();  // m
  double weight = 1.0;                               // all together 1
};

// A Gaussian part of what a round leaves possible.
struct PlacePart {
  double share = 1.0;                                        // of all parts together 1
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();            // m, of the antenna in the round's middle
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // m^2
};

struct RoundMatch {
  std::vector<PlacePart> parts;  // one; two or three along the longer axis where one would be wider than allowed
  double evidence = 0.0;         // probability of the outcomes, given the prior
  std::vector<double> inside;    // per outcome, how likely the tag was well inside the footprint, afterwards
  std::vector<double> chance;    // per outcome, how likely the tag was to be read, given the prior
};

struct RoundMatchParameters {
  double false_read = 1e-4;  // probability that a tag out of reach seems to answer
  double span = 3.5;         // standard deviations that the grid covers
  int least_points = 15;     // of the grid, each way: a spacing of half a standard deviation
  int most_points = 61;
  double widest = 2.0;  // softnesses: a Gaussian with a larger standard deviation bends around the footprint's edge
};

// The moments of a round at which each tag is tried: nodes of a quadrature along the antenna's `way` (m) through the
// round; one alone while it stands.
std::vector<WindowPoint> window_points(const Eigen::Vector2d& way);

// Moments by quadrature over a grid on the prior's ellipse (assumed density filtering; Maybeck, Stochastic Models,
// Estimation and Control, vol. 2, 1982, section 12.7). `prior_covariance` positive definite, `window` not empty.
RoundMatch match_round(const Eigen::Vector2d& prior_mean, const Eigen::Matrix2d& prior_covariance,
                       const std::vector<TagOutcome>& outcomes, const std::vector<WindowPoint>& window,
                       const ReadModel& model, const RoundMatchParameters& parameters);

}  // namespace markservo::rfid_localizer
