#include "services/rfid-localizer/hypothesis.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {
namespace {

StateVector difference(const StateVector& a, const StateVector& b, int angle) {
  StateVector d = a - b;
  if (angle >= 0) d[angle] = geometry::wrapped(d[angle]);
  return d;
}

bool close(const Hypothesis& a, const Hypothesis& b, double distance, int angle) {
  const StateVector d = difference(a.mean, b.mean, angle);
  for (int i = 0; i < d.size(); ++i) {
    const double variance = std::min(a.covariance(i, i), b.covariance(i, i));
    if (d[i] * d[i] > distance * distance * variance) return false;
  }
  return true;
}

void normalise(Mixture& mixture) {
  double sum = 0.0;
  for (const Hypothesis& one : mixture) sum += one.weight;
  for (Hypothesis& one : mixture) one.weight /= sum;
}

void merge_close(Mixture& mixture, double distance, int angle) {
  for (std::size_t i = 0; i < mixture.size(); ++i) {
    for (std::size_t j = i + 1; j < mixture.size();) {
      if (close(mixture[i], mixture[j], distance, angle)) {
        mixture[i] = moments({mixture[i], mixture[j]}, angle);
        mixture.erase(mixture.begin() + static_cast<std::ptrdiff_t>(j));
      } else {
        ++j;
      }
    }
  }
}

}  // namespace

double larger_sigma(const Eigen::Matrix2d& covariance) {
  return std::sqrt(std::max(0.0, covariance.eigenvalues().real().maxCoeff()));
}

Hypothesis moments(const Mixture& mixture, int angle) {
  const auto heaviest = std::max_element(mixture.begin(), mixture.end(),
                                         [](const Hypothesis& a, const Hypothesis& b) { return a.weight < b.weight; });
  // An angle's mean is that of its direction on the circle; its offsets are told from there.
  StateVector centre = heaviest->mean;
  double sum = 0.0;
  double sine = 0.0;
  double cosine = 0.0;
  for (const Hypothesis& one : mixture) {
    sum += one.weight;
    if (angle < 0) continue;
    sine += one.weight * std::sin(one.mean[angle]);
    cosine += one.weight * std::cos(one.mean[angle]);
  }
  constexpr double kNoDirection = 1e-6;
  if (angle >= 0 && std::hypot(sine, cosine) > kNoDirection * sum) centre[angle] = std::atan2(sine, cosine);

  Hypothesis result;
  StateVector offset = StateVector::Zero();
  for (const Hypothesis& one : mixture) offset += one.weight / sum * difference(one.mean, centre, angle);
  result.mean = centre + offset;
  for (const Hypothesis& one : mixture) {
    const StateVector d = difference(one.mean, result.mean, angle);
    result.covariance += one.weight / sum * (one.covariance + d * d.transpose());
  }
  result.mode = heaviest->mode;
  result.weight = sum;
  if (angle >= 0) result.mean[angle] = geometry::wrapped(result.mean[angle]);
  return result;
}

void tidy(Mixture& mixture, double least, double distance, std::size_t most, int angle) {
  normalise(mixture);
  std::sort(mixture.begin(), mixture.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.weight > b.weight; });
  while (mixture.size() > 1 && mixture.back().weight < least) mixture.pop_back();

  merge_close(mixture, distance, angle);
  // What is too many is held more coarsely: to drop the lightest would claim to know more.
  constexpr double kCoarser = 1.5;
  constexpr int kCoarsest = 40;  // steps; what is still apart then has no width at all
  for (int step = 0; step < kCoarsest && mixture.size() > most; ++step) {
    distance *= kCoarser;
    merge_close(mixture, distance, angle);
  }
  normalise(mixture);
}

}  // namespace markservo::rfid_localizer
