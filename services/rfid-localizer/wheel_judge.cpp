#include "services/rfid-localizer/wheel_judge.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {
namespace {

double square(double x) {
  return x * x;
}

// The nearest matrix without eigenvalues below 0: a round that leaves more doubt than it found tells nothing.
Eigen::Matrix2d nonnegative(const Eigen::Matrix2d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(symmetric);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
}

double trace_of_product(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
  return (a * b).trace();
}

}  // namespace

WheelJudge::WheelJudge(const WheelNoise& stated, const WheelJudgeParameters& parameters)
    : stated_(stated),
      parameters_(parameters),
      believed_(stated),
      information_(Eigen::Matrix2d::Zero()),
      fits_(square(stated.drift / parameters.slip_margin), square(stated.pivot_wander)),
      judged_with_(square(stated.drift), square(stated.pivot_wander)) {
  for (const int i : {kDrift, kWander}) {
    information_(i, i) = 0.5 * parameters.worth / square(std::max(judged_with_[i], least_square(i)));
  }
  evidence_ = information_ * fits_;
  restart();
}

double WheelJudge::least_square(int number) const {
  return square(number == kDrift ? parameters_.drift_unit : parameters_.wander_unit);
}

Eigen::Vector2d WheelJudge::unconstrained() const {
  return information_.inverse() * evidence_;
}

void WheelJudge::restart() {
  drift_.setZero();
  wander_.setZero();
  used_.setZero();
}

void WheelJudge::moved(const StateVector& state, const WheelMotion& motion) {
  const StateCovariance F = motion_jacobian(state, motion);
  const NoiseShares shares = noise_shares(state, motion, believed_);
  const auto carry = [&F](StateCovariance& errors, const StateCovariance& more) {
    errors = F * errors * F.transpose() + more;
  };
  carry(drift_, shares.drift);
  carry(wander_, shares.pivot_wander);
  carry(used_, square(believed_.drift) * shares.drift + square(believed_.pivot_wander) * shares.pivot_wander);
}

void WheelJudge::matched(const Hypothesis& before, const Hypothesis& after, const Eigen::Matrix<double, 2, 5>& H) {
  const StateCovariance& P = before.covariance;
  const Eigen::Matrix2d S = H * P * H.transpose();
  if (larger_sigma(S) > parameters_.widest_place || P(kHeading, kHeading) > square(parameters_.widest_heading)) {
    restart();
    return;
  }
  StateVector change = after.mean - before.mean;
  change[kHeading] = geometry::wrapped(change[kHeading]);
  const Eigen::Matrix2d inverse = S.inverse();
  const Eigen::Vector2d g = inverse * H * change;
  const Eigen::Matrix2d expected = inverse * (S - H * after.covariance * H.transpose()) * inverse;  // of g g^T
  const Eigen::Matrix2d G = nonnegative(0.5 * (expected + expected.transpose()));

  const Eigen::Matrix2d errors[] = {H * drift_ * H.transpose(), H * wander_ * H.transpose()};
  const Eigen::Matrix2d used = H * used_ * H.transpose();
  const Eigen::Matrix2d surplus = g * g.transpose() - expected + G * used * G;
  for (const int i : {kDrift, kWander}) {
    evidence_[i] += 0.5 * trace_of_product(surplus, errors[i]);
    for (const int j : {kDrift, kWander}) {
      information_(i, j) += 0.5 * trace_of_product(G * errors[j] * G, errors[i]);
    }
  }

  const StateCovariance left = StateCovariance::Identity() - P * H.transpose() * G * H;
  for (StateCovariance* one : {&drift_, &wander_, &used_}) *one = left * *one * left.transpose();
  solve();
}

void WheelJudge::limit(int number, double draws) {
  const double most = 0.5 * draws / square(std::max(fits_[number], least_square(number)));
  if (information_(number, number) <= most) return;
  const Eigen::Vector2d squares = unconstrained();
  const double share = std::sqrt(most / information_(number, number));
  information_.row(number) *= share;
  information_.col(number) *= share;
  evidence_ = information_ * squares;
}

void WheelJudge::solve() {
  fits_ = unconstrained();
  // A square is not below 0: the other number then fits alone.
  for (const int i : {kDrift, kWander}) {
    if (fits_[i] >= 0.0) continue;
    fits_[i] = 0.0;
    fits_[1 - i] = std::max(0.0, evidence_[1 - i] / information_(1 - i, 1 - i));
  }
  fits_ = fits_.cwiseMin(Eigen::Vector2d(square(parameters_.most_drift), square(parameters_.most_wander)));

  const Eigen::Vector2d used(square(stated_.drift), square(stated_.pivot_wander));
  const Eigen::Matrix2d covariance = information_.inverse();
  for (const int i : {kDrift, kWander}) {
    // Once it is wrong it stays so until what is stated fits.
    const double chance = too_small_[i] ? 0.0 : parameters_.certain * std::sqrt(covariance(i, i));
    too_small_[i] = fits_[i] > used[i] + chance;
    limit(i, parameters_.memory);
    if (!too_small_[i] || fits_[i] < parameters_.anew * judged_with_[i]) continue;
    judged_with_[i] = fits_[i];
    limit(i, parameters_.worth);
  }
  believed_ = stated_;
  if (too_small_[kDrift]) {
    believed_.drift = std::max(stated_.drift, parameters_.slip_margin * std::sqrt(fits_[kDrift]));
  }
  if (too_small_[kWander]) believed_.pivot_wander = std::sqrt(fits_[kWander]);
}

WheelJudgement WheelJudge::judgement() const {
  WheelJudgement result;
  result.drift.stated = stated_.drift / parameters_.slip_margin;
  result.drift.fits = std::sqrt(fits_[kDrift]);
  result.drift.too_small = too_small_[kDrift];
  result.pivot_wander.stated = stated_.pivot_wander;
  result.pivot_wander.fits = std::sqrt(fits_[kWander]);
  result.pivot_wander.too_small = too_small_[kWander];
  return result;
}

}  // namespace markservo::rfid_localizer
