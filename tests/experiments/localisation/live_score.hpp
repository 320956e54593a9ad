#pragma once

// Scores the live pose against the truth.

#include <Eigen/Core>
#include <vector>

#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

// What ROBOT_POSE says.
struct PoseEstimate {
  double time = 0.0;                                         // s, when it held
  Eigen::Vector2d p_WR = Eigen::Vector2d::Zero();            // m
  double heading = 0.0;                                      // rad
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  // of (x, y, heading): m^2, m rad, rad^2
  double speed = 0.0;                                        // m/s
  double turn_rate = 0.0;                                    // rad/s
  bool localised = false;                                    // its own claim
};

struct LiveScoreParameters {
  double diverged_error = 0.15;  // m: more than a footprint, so the reads contradict the pose
  int diverged_samples = 2;      // in a row, after settling; one alone may be the last of the start
  double driving_speed = 0.05;   // m/s, from which a heading is asked for
};

// Errors at the sampled times; "settled" are those at or after the time given for that.
struct LiveScore {
  std::vector<double> all;              // m, radial
  std::vector<double> settled;          // m, radial
  std::vector<double> settled_heading;  // rad, absolute, while driving
  std::vector<double> settled_nees;     // of (x, y, heading), 3 degrees of freedom, where it claims to be localised
  int settled_not_localised = 0;        // samples at which it does not claim so
  int without_pose = 0;                 // samples before any estimate: they have no error
  bool diverged = false;
};

// `estimates` in order of time; at each of `times` (s, rising) the newest one counts, moved on at its own speed and
// turn rate, as one who drives by it would. Throws std::invalid_argument if the estimates are out of order.
LiveScore score_live(const std::vector<PoseEstimate>& estimates, const TruePath& path, const std::vector<double>& times,
                     double settled_from, const LiveScoreParameters& parameters = {});

// The newest of `estimates` at `time` (s), moved on to it; null before the first.
const PoseEstimate* newest(const std::vector<PoseEstimate>& estimates, double time);
PoseEstimate moved_on(PoseEstimate estimate, double time);

}  // namespace markservo::experiments
