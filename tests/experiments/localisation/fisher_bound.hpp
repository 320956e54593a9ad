#pragma once

// How well the live pose can be known at all: the posterior Cramer-Rao bound of a run, a covariance recursion along the
// true path. No estimate enters it.

#include <Eigen/Core>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "tests/experiments/localisation/read_information.hpp"
#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

// A round of the reader as it reaches whoever localises.
struct RoundTimes {
  double middle = 0.0;   // s, of the reading
  double arrival = 0.0;  // s
};

// What is known at the middle of the first round, before it.
struct BoundPrior {
  Eigen::Vector2d position_variance = Eigen::Vector2d::Zero();  // m^2, each axis; width^2 / 12 of a uniform one
  double heading_variance = 0.0;                                // rad^2; pi^2 / 3 where nothing is known
  double delay_variance = 0.0;                                  // s^2, of the delay from middle to arrival
};

// How the encoders err, as the simulated base has it: one scale for the whole run, and random walks with the way that
// its wheels went (where the path does not tell it: that of the base) and the angle that they turned it by.
struct EncoderNoise {
  double scale_sigma = 0.02;                      // of way and turn alike
  double heading_drift = geometry::radians(2.0);  // rad/sqrt(m)
  double along = 0.0;                             // m/sqrt(m): drift * track / 2 of two wheels that err on their own
  double pivot_wander = 0.0;                      // m/sqrt(rad), each axis, while the wheels turn the base
};

// How a base without encoders may move: its velocity drifts by white acceleration, and is unknown at first.
struct FreeMotion {
  double acceleration = 0.02;  // m/s^1.5, each axis: cruising, the quietest motion that rfid-localizer expects
  double speed_sigma = 0.5;    // m/s, each axis of the velocity at first
};

struct BoundInput {
  ReaderModel reader;
  std::vector<RoundTimes> rounds;  // one or more, in order
  std::vector<double> times;       // s, rising, none before the first round's arrival
  BoundPrior prior;
};

// The bound on the covariance of (x, y, heading, delay) at each of `input.times`, from the rounds that have arrived by
// then, moved on from the middle of the last one. State: pose, delay, scale of the encoders. Throws
// std::invalid_argument if rounds or times are not as BoundInput says.
std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const EncoderNoise& noise);

// The same without encoders. State: place, velocity, delay; the heading is the velocity's, and its variance infinite
// while the base stands.
std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const FreeMotion& motion);

}  // namespace markservo::experiments
