#pragma once

// What the filter believes: weighted Gaussians. With encoders a Gaussian is over (x, y, heading, wheel scale error,
// reader delay), without over (x, y, velocity x, velocity y, reader delay), of the robot in W at the filter's time.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace markservo::rfid_localizer {

using StateVector = Eigen::Matrix<double, 5, 1>;
using StateCovariance = Eigen::Matrix<double, 5, 5>;

// Places in the state.
inline constexpr int kX = 0;          // m
inline constexpr int kY = 1;          // m
inline constexpr int kHeading = 2;    // rad, with encoders
inline constexpr int kScale = 3;      // true way over the wheels' minus 1, with encoders
inline constexpr int kVelocityX = 2;  // m/s, without
inline constexpr int kVelocityY = 3;  // m/s, without
inline constexpr int kDelay = 4;      // s, from the middle of a round to its arrival

struct Hypothesis {
  int mode = 0;         // without encoders: a way to move (free_motion.hpp)
  double weight = 1.0;  // all together 1
  StateVector mean = StateVector::Zero();
  StateCovariance covariance = StateCovariance::Zero();

  Eigen::Matrix2d place() const { return covariance.topLeftCorner<2, 2>(); }  // m^2, of (x, y)
};

// Standard deviation along the longer axis.
double larger_sigma(const Eigen::Matrix2d& covariance);

using Mixture = std::vector<Hypothesis>;

// The Gaussian with the mixture's own mean and covariance. `angle` is the place of an angle that wraps, or -1.
Hypothesis moments(const Mixture& mixture, int angle);

// Brings the weights to a sum of 1, drops hypotheses lighter than `least`, and merges those closer than `distance`
// standard deviations of their own in every place; while there are more than `most` (above 0), those a little
// farther apart too. At least one stays.
void tidy(Mixture& mixture, double least, double distance, std::size_t most, int angle);

}  // namespace markservo::rfid_localizer
