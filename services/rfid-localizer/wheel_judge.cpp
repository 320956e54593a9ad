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
Eigen::Matrix2d nonnegative(const Eigen::Matrix2d& matrix) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(0.5 * (matrix + matrix.transpose()));
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() * solver.eigenvectors().transpose();
}

double trace_of_product(const StateCovariance& symmetric, const StateCovariance& other) {
  return symmetric.cwiseProduct(other).sum();
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

void WheelJudge::forget_errors() {
  sources_.fill(StateCovariance::Zero());
  slopes_.fill(Slope{});
}

void WheelJudge::restart() {
  forget_errors();
  following_ = false;
}

bool WheelJudge::follow(double place_sigma, double heading_sigma) {
  const auto within = [&](double factor) {
    return place_sigma <= factor * parameters_.known_place && heading_sigma <= factor * parameters_.known_heading;
  };
  if (following_ && !within(parameters_.no_longer)) restart();
  if (!following_) following_ = within(1.0);
  return following_;
}

void WheelJudge::moved(const StateVector& state, const WheelMotion& motion) {
  if (!following_) return;
  const StateCovariance F = motion_jacobian(state, motion);
  const NoiseShares shares = noise_shares(state, motion, believed_);
  for (Source& source : sources_) source = F * source * F.transpose();
  sources_[kDrift] += shares.drift;
  sources_[kWander] += shares.pivot_wander;
  sources_[kUsed] += square(believed_.drift) * shares.drift + square(believed_.pivot_wander) * shares.pivot_wander;
  for (Slope& slope : slopes_) {
    slope.mean = F * slope.mean;
    for (StateCovariance& common : slope.common) common = F * common * F.transpose();
  }
}

void WheelJudge::matched(const Hypothesis& before, const Hypothesis& after, const Eigen::Matrix<double, 2, 5>& H) {
  const StateCovariance& P = before.covariance;
  const Eigen::Matrix2d S = H * P * H.transpose();
  if (!follow(larger_sigma(S), std::sqrt(P(kHeading, kHeading)))) return;
  StateVector change = after.mean - before.mean;
  change[kHeading] = geometry::wrapped(change[kHeading]);
  const Eigen::Matrix2d inverse = S.inverse();
  // A round's likelihood is no Gaussian: only the slope of its logarithm by the antenna's place, and what that slope
  // squared is on average, hold whatever its form.
  const Eigen::Vector2d g = inverse * H * change;
  const Eigen::Matrix2d G = nonnegative(inverse * (S - H * after.covariance * H.transpose()) * inverse);
  const StateCovariance HGH = H.transpose() * G * H;

  const Eigen::Vector2d believed(square(believed_.drift), square(believed_.pivot_wander));
  for (const int i : {kDrift, kWander}) {
    const double news = trace_of_product(HGH, slopes_[i].common[i]);
    const double most = parameters_.most_surprise * std::sqrt(std::max(0.0, news));
    const double agreement = std::clamp(g.dot(H * slopes_[i].mean), -most, most);
    evidence_[i] += agreement + trace_of_product(HGH, slopes_[i].common[kUsed]);
    for (const int j : {kDrift, kWander}) information_(i, j) += trace_of_product(HGH, slopes_[i].common[j]);
    judged_with_[i] += news / information_(i, i) * (believed[i] - judged_with_[i]);
    fresh_[i] += news;
  }

  const StateCovariance left = StateCovariance::Identity() - P * HGH;
  for (const int i : {kDrift, kWander}) {
    Slope& slope = slopes_[i];
    slope.mean = left * (slope.mean + sources_[i] * H.transpose() * g);
    for (const int j : {kDrift, kWander, kUsed}) {
      slope.common[j] = left * (slope.common[j] + sources_[j] * HGH * sources_[i]) * left.transpose();
    }
  }
  for (Source& source : sources_) source = left * source * left.transpose();
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
  const Eigen::Vector2d least = used + Eigen::Vector2d(0.0, square(parameters_.least_wander));
  const Eigen::Matrix2d covariance = information_.inverse();
  Eigen::Vector2d believed = used;
  for (const int i : {kDrift, kWander}) {
    const double chance = too_small_[i] ? 0.0 : parameters_.certain * std::sqrt(covariance(i, i));
    too_small_[i] = fits_[i] > std::max(least[i], used[i] + chance);
    limit(i, parameters_.memory);
    if (!too_small_[i]) continue;
    const double unit = std::max(judged_with_[i], least_square(i));
    const double believable = std::min(fits_[i], parameters_.growth * unit);
    believed[i] = believable;
    const bool grown = fits_[i] > parameters_.anew * judged_with_[i];
    if (!grown || 2.0 * fresh_[i] * unit * unit < parameters_.fresh) continue;
    judged_with_[i] = fits_[i] = believable;
    for (const int each : {kDrift, kWander}) limit(each, parameters_.worth);
    evidence_ = information_ * fits_;
    fresh_.setZero();
    // What made it grow has told what it can: each round that still mends it would count it again.
    forget_errors();
  }
  believed_ = stated_;
  if (too_small_[kDrift]) {
    believed_.drift = std::max(stated_.drift, parameters_.slip_margin * std::sqrt(believed[kDrift]));
  }
  if (too_small_[kWander]) believed_.pivot_wander = std::sqrt(believed[kWander]);
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
