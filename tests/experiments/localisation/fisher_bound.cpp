#include "tests/experiments/localisation/fisher_bound.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markservo::experiments {
namespace {

// At 1 m/s a step is 2 cm: what turns and drifts within it is far below what the bound is rounded to.
constexpr double kLongestStep = 0.02;  // s

// Both states begin with x, y, heading, delay.
constexpr int kScale = 4;
constexpr int kSpeed = 4;
constexpr int kTurnRate = 5;

// The motion's derivatives by the state, and the noise it adds, over one step of the true path.
template <int n>
struct Step {
  Eigen::Matrix<double, n, n> transition = Eigen::Matrix<double, n, n>::Identity();
  Eigen::Matrix<double, n, n> noise = Eigen::Matrix<double, n, n>::Zero();
};

Step<5> step(const PathPoint& from, const PathPoint& to, const EncoderNoise& noise) {
  const Eigen::Vector2d way = to.p_WR - from.p_WR;
  const double length = way.norm();
  Step<5> result;
  result.transition(0, 2) = -way.y();
  result.transition(1, 2) = way.x();
  result.transition.block<2, 1>(0, kScale) = way;
  result.transition(2, kScale) = to.heading - from.heading;
  if (length > 0.0) {
    result.noise.topLeftCorner<2, 2>() = noise.along * noise.along / length * way * way.transpose();
  }
  result.noise(2, 2) = noise.heading_drift * noise.heading_drift * length;
  return result;
}

Step<6> step(const PathPoint& from, const PathPoint& to, const FreeMotion& motion) {
  const Eigen::Vector2d way = to.p_WR - from.p_WR;
  const double dt = to.time - from.time;
  const double heading = 0.5 * (from.heading + to.heading);
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  Step<6> result;
  result.transition(0, 2) = -way.y();
  result.transition(1, 2) = way.x();
  result.transition.block<2, 1>(0, kSpeed) = dt * along;
  result.transition(0, kTurnRate) = -way.y() * 0.5 * dt;
  result.transition(1, kTurnRate) = way.x() * 0.5 * dt;
  result.transition(2, kTurnRate) = dt;
  const double q = motion.acceleration * motion.acceleration;
  result.noise.topLeftCorner<2, 2>() = q * dt * dt * dt / 3.0 * along * along.transpose();
  result.noise.block<2, 1>(0, kSpeed) = q * dt * dt / 2.0 * along;
  result.noise.block<1, 2>(kSpeed, 0) = q * dt * dt / 2.0 * along.transpose();
  result.noise(kSpeed, kSpeed) = q * dt;
  const double q_turn = motion.turn_acceleration * motion.turn_acceleration;
  result.noise(2, 2) = q_turn * dt * dt * dt / 3.0;
  result.noise(2, kTurnRate) = result.noise(kTurnRate, 2) = q_turn * dt * dt / 2.0;
  result.noise(kTurnRate, kTurnRate) = q_turn * dt;
  return result;
}

template <int n, class Motion>
void move_on(Eigen::Matrix<double, n, n>& covariance, const TruePath& path, double from, double to,
             const Motion& motion) {
  const int steps = static_cast<int>(std::ceil((to - from) / kLongestStep));
  PathPoint before = path.at(from);
  for (int i = 1; i <= steps; ++i) {
    const PathPoint after = path.at(from + (to - from) * i / steps);
    const auto moved = step(before, after, motion);
    covariance = moved.transition * covariance * moved.transition.transpose() + moved.noise;
    before = after;
  }
}

template <int n>
void learn(Eigen::Matrix<double, n, n>& covariance, const ReadInformation& read) {
  using Matrix = Eigen::Matrix<double, n, n>;
  Matrix information = Matrix::Zero();
  information.template topLeftCorner<4, 4>() = read;
  // (P^-1 + J)^-1 without P's inverse: a scale or delay that is known for certain makes P singular.
  const Matrix gain = (Matrix::Identity() + covariance * information).inverse();
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

template <int n, class Motion>
std::vector<Eigen::Matrix4d> recursion(const BoundInput& input, const TruePath& path, const Motion& motion,
                                       Eigen::Matrix<double, n, n> covariance) {
  check(input);
  covariance.template topLeftCorner<4, 4>().diagonal() << input.prior.position_variance, input.prior.heading_variance,
      input.prior.delay_variance;
  std::vector<Eigen::Matrix4d> bounds;
  bounds.reserve(input.times.size());
  std::size_t next = 0;  // round that has not been learnt from
  double middle = input.rounds.front().middle;
  for (const double time : input.times) {
    for (; next < input.rounds.size() && input.rounds[next].arrival <= time; ++next) {
      move_on<n>(covariance, path, middle, input.rounds[next].middle, motion);
      middle = input.rounds[next].middle;
      learn<n>(covariance, read_information(input.reader, path, middle));
    }
    Eigen::Matrix<double, n, n> live = covariance;
    move_on<n>(live, path, middle, time, motion);
    bounds.push_back(live.template topLeftCorner<4, 4>());
  }
  return bounds;
}

}  // namespace

std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const EncoderNoise& noise) {
  Eigen::Matrix<double, 5, 5> covariance = Eigen::Matrix<double, 5, 5>::Zero();
  covariance(kScale, kScale) = noise.scale_sigma * noise.scale_sigma;
  return recursion<5>(input, path, noise, covariance);
}

std::vector<Eigen::Matrix4d> live_bound(const BoundInput& input, const TruePath& path, const FreeMotion& motion) {
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
  covariance(kSpeed, kSpeed) = motion.speed_variance;
  covariance(kTurnRate, kTurnRate) = motion.turn_rate_variance;
  return recursion<6>(input, path, motion, covariance);
}

}  // namespace markservo::experiments
