#pragma once

// How hypotheses move between rounds: by the wheels, or, on a robot without encoders, by inertia.

#include <Eigen/Core>
#include <cmath>
#include <cstdint>

#include "services/rfid-localizer/hypothesis.hpp"

namespace markservo::rfid_localizer {

// A Gaussian over a place on the floor, in W.
struct Place {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();            // m
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();  // m^2
};

struct DelayPrior {
  double mean = 0.0;   // s, from the middle of a round to its arrival
  double sigma = 0.0;  // s
};

// Where the antenna is by a hypothesis, linearised.
struct AntennaView {
  Eigen::Vector2d p_WF = Eigen::Vector2d::Zero();                       // m
  Eigen::Matrix<double, 2, 5> H = Eigen::Matrix<double, 2, 5>::Zero();  // of p_WF by the state, but for the delay
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();                   // m/s
};

// The robot's pose and motion, with the covariance of (x, y, heading).
struct PoseEstimate {
  Eigen::Vector3d pose = Eigen::Vector3d::Zero();  // m, m, rad: X_WR
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double speed = 0.0;      // m/s, forward
  double turn_rate = 0.0;  // rad/s
};

// rad^2, of a heading of which nothing is known.
inline constexpr double kAnyHeading = M_PI * M_PI / 3.0;

class Motion {
 public:
  virtual ~Motion() = default;

  // All that can be believed of a robot whose antenna is at `place`, and of which nothing else is known.
  virtual Mixture start(const Place& place, const DelayPrior& delay) const = 0;
  // Moves a mixture on from time `from` to `to` (us).
  virtual void predict(Mixture& mixture, std::int64_t from, std::int64_t to) const = 0;
  // `middle` is the hypothesis' time, `round` (us) the length of a round around it.
  virtual AntennaView antenna(const Hypothesis& hypothesis, std::int64_t middle, std::int64_t round) const = 0;
  // Whether the reads may teach the delay: told from an acceleration only where that is measured. Else it is a nuisance
  // whose uncertainty counts (Schmidt, Advances in Control Systems 3, 1966).
  virtual bool learns_delay() const = 0;
  // The place of the state's angle, or -1.
  virtual int angle() const = 0;
  virtual void clean(Mixture& mixture) const = 0;
  // What the mixture says at its time.
  virtual PoseEstimate pose(const Mixture& mixture, std::int64_t utime) const = 0;
};

}  // namespace markservo::rfid_localizer
