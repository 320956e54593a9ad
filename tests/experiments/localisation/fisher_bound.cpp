#include "tests/experiments/localisation/fisher_bound.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace markservo::experiments {
namespace {

// At 1 m/s a step is 2 cm: what turns and drifts within it is far below what the bound is rounded to.
constexpr double kLongestStep = 0.02;  // s

// State with encoders: x, y, heading, delay, scale.
constexpr int kScale = 4;
// State without: x, y, velocity x, velocity y, delay.
constexpr int kVelocity = 2;
constexpr int kFreeDelay = 4;
// The heading of a base that is slower than this is not that of its velocity.
constexpr double kLeastSpeed = 0.01;  // m/s

using Covariance = Eigen::Matrix<double, 5, 5>;

// The motion's derivatives by the state, and the noise it adds, over one step of the true path.
struct Step {
  Covariance transition = Covariance::Identity();
  Covariance noise = Covariance::Zero();
};

Step step(const PathPoint& from, const PathPoint& to, const EncoderNoise& noise) {
  const Eigen::Vector2d way = to.p_WR - from.p_WR;
  const double length = way.norm();
  Step result;
  result.transition(0, 2) = -way.y();
  result.transition(1, 2) = way.x();
  result.transition.block<2, 1>(0, kScale) = way;
  result.transition(2, kScale) = to.heading - from.heading;
  const bool wheels_told = to.wheel_travel > 0.0;
  const double travel = wheels_told ? to.wheel_travel - from.wheel_travel : length;
  const double heading = 0.5 * (from.heading + to.heading);
  // The wheels' own way is along the heading; a base that wanders goes elsewhere.
  const Eigen::Vector2d along = wheels_told    ? Eigen::Vector2d(std::cos(heading), std::sin(heading))
                                : length > 0.0 ? Eigen::Vector2d(way / length)
                                               : Eigen::Vector2d::Zero();
  result.noise.topLeftCorner<2, 2>() = noise.along * noise.along * travel * along * along.transpose();
  const double wander = noise.pivot_wander * noise.pivot_wander * (to.turned - from.turned);
  result.noise(0, 0) += wander;
  result.noise(1, 1) += wander;
  result.noise(2, 2) = noise.heading_drift * noise.heading_drift * travel;
  return result;
}

Step step(const PathPoint& from, const PathPoint& to, const FreeMotion& motion) {
  const double dt = to.time - from.time;
  const double q = motion.acceleration * motion.acceleration;
  Step result;
  for (const int axis : {0, 1}) {
    const int velocity = kVelocity + axis;
    result.transition(axis, velocity) = dt;
    result.noise(axis, axis) = q * dt * dt * dt / 3.0;
    result.noise(axis, velocity) = result.noise(velocity, axis) = q * dt * dt / 2.0;
    result.noise(velocity, velocity) = q * dt;
  }
  return result;
}

// (x, y, heading, delay) by the state.
using PoseOfState = Eigen::Matrix<double, 4, 5>;

PoseOfState pose_of_state(const PathPoint&, const EncoderNoise&) {
  return PoseOfState::Identity();
}

PoseOfState pose_of_state(const PathPoint& truth, const FreeMotion&) {
  PoseOfState pose = PoseOfState::Zero();
  pose(0, 0) = pose(1, 1) = pose(3, kFreeDelay) = 1.0;
  if (truth.speed > kLeastSpeed) {
    pose(2, kVelocity) = -std::sin(truth.heading) / truth.speed;
    pose(2, kVelocity + 1) = std::cos(truth.heading) / truth.speed;
  }
  return pose;
}

Covariance first_covariance(const BoundPrior& prior, const EncoderNoise& noise) {
  Covariance covariance = Covariance::Zero();
  covariance.diagonal() << prior.position_variance, prior.heading_variance, prior.delay_variance,
      noise.scale_sigma * noise.scale_sigma;
  return covariance;
}

Covariance first_covariance(const BoundPrior& prior, const FreeMotion& motion) {
  Covariance covariance = Covariance::Zero();
  const double speed_variance = motion.speed_sigma * motion.speed_sigma;
  covariance.diagonal() << prior.position_variance, speed_variance, speed_variance, prior.delay_variance;
  return covariance;
}

template <class Motion>
void move_on(Covariance& covariance, const TruePath& path, double from, double to, const Motion& motion) {
  const int steps = static_cast<int>(std::ceil((to - from) / kLongestStep));
  PathPoint before = path.at(from);
  for (int i = 1; i <= steps; ++i) {
    const PathPoint after = path.at(from + (to - from) * i / steps);
    const Step moved = step(before, after, motion);
    covariance = moved.transition * covariance * moved.transition.transpose() + moved.noise;
    before = after;
  }
}

void learn(Covariance& covariance, const ReadInformation& read, const PoseOfState& pose) {
  const Covariance information = pose.transpose() * read * pose;
  // (P^-1 + J)^-1 without P's inverse: a scale or delay that is known for certain makes P singular.
  const Covariance gain = (Covariance::Identity() + covariance * information).inverse();
  covariance = gain * covariance;
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
}

void check(const BoundInput& input) {
  if (input.rounds.empty()) throw std::invalid_argument("live_bound: no rounds");
  for (std::size_t i = 0; i < input.rounds.size(); ++i) {
    if (input.rounds[i].arrival < input.rounds[i].middle) {
      throw std::invalid_argument("live_bound: a round that arrives before it is read");
    }
    if (i > 0 && input.rounds[i].middle < input.rounds[i - 1].middle) {
      throw std::invalid_argument("live_bound: rounds out of order");
    }
  }
  if (!std::is_sorted(input.times.begin(), input.times.end())) {
    throw std::invalid_argument("live_bound: times out of order");
  }
  if (!input.times.empty() && input.times.front() < input.rounds.front().arrival) {
    throw std::invalid_argument("live_bound: a time before the first round's arrival");
  }
}

template <class Motion>
std::vector<Eigen::Matrix4d> recursion(const BoundInput& input, const TruePath& path, const Motion& motion) {
  check(input);
  Covariance covariance = first_covariance(input.prior, motion);
  std::vector<Eigen::Matrix4d> bounds;
  bounds.reserve(input.times.size());
  std::size_t next = 0;  // round that has not been learnt from
  double middle = input.rounds.front().middle;
  for (const double time : input.times) {
    for (; next < input.rounds.size() && input.rounds[next].arrival <= time; ++next) {
      move_on(covariance, path, middle, input.rounds[next].middle, motion);
      middle = input.rounds[next].middle;
      learn(covariance, read_information(input.reader, path, middle), pose_of_state(path.at(middle), motion));
    }
    Covariance live = covariance;
    move_on(live, path, middle, time, motion);
    const PoseOfState pose = pose_of_state(path.at(time), motion);
    bounds.push_back(pose * live * pose.transpose());
    if (pose.row(2).isZero()) bounds.back()(2, 2) = std::numeric_limits<double>::infinity();
  }
  return bounds;
}

}  // namespace

std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const EncoderNoise& noise) {
  return recursion(input, path, noise);
}

std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const FreeMotion& motion) {
  return recursion(input, path, motion);
}

}  // namespace markservo::experiments
