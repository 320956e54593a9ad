#include "services/target-locator/outline/edge_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markservo::target_locator {
namespace {

// Neighbouring points share texture: how many of them count as one, from the correlation of their residuals.
double points_per_independent_one(const EdgePoints& points) {
  constexpr std::size_t kLongestLag = 8;
  float squares = 0.0F;
  float products = 0.0F;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].good) continue;
    squares += points[i].residual * points[i].residual;
    const std::size_t end = std::min(points.size(), i + kLongestLag + 1);
    for (std::size_t k = i + 1; k < end; ++k) {
      if (points[k].good) products += points[i].residual * points[k].residual;
    }
  }
  // Fitting the line takes its share of the correlation away, so that even independent points count as two.
  return squares > 0.0F ? std::clamp(2.0 + 2.0 * static_cast<double>(products / squares), 2.0, 10.0) : 2.0;
}

// Standard deviation of the residuals without the largest.
float robust_sigma(const EdgePoints& points) {
  constexpr float kPerMean = 1.2533F;  // of a normal distribution, over its mean size
  float limit = std::numeric_limits<float>::max();
  float sigma = 0.0F;
  for (int pass = 0; pass < 3; ++pass) {
    float sum = 0.0F;
    float n = 0.0F;
    for (const EdgePoint& point : points) {
      const float size = std::abs(point.residual);
      if (size > limit) continue;
      sum += size;
      n += 1.0F;
    }
    sigma = kPerMean * sum / std::max(n, 1.0F);
    limit = 2.5F * sigma;
  }
  return sigma;
}

}  // namespace

std::optional<EdgeLine> fit_edge_line(EdgePoints& points, float tolerance) {
  constexpr std::size_t kLeastPoints = 6;
  if (points.size() < kLeastPoints) return std::nullopt;
  constexpr int kPasses = 5;
  for (EdgePoint& point : points) point.good = true;
  EdgeLine line;
  for (int pass = 1; pass <= kPasses; ++pass) {
    float n = 0.0F;
    float st = 0.0F;
    float sz = 0.0F;
    float stt = 0.0F;
    float stz = 0.0F;
    for (const EdgePoint& point : points) {
      if (!point.good) continue;
      n += 1.0F;
      st += point.along;
      sz += point.across;
      stt += point.along * point.along;
      stz += point.along * point.across;
    }
    const float determinant = n * stt - st * st;
    line.good = static_cast<std::size_t>(n);
    if (line.good < kLeastPoints || !(determinant > 1e-6F)) return std::nullopt;
    const float q = (n * stz - st * sz) / determinant;
    const float p = (stt * sz - st * stz) / determinant;
    float squares = 0.0F;
    for (EdgePoint& point : points) {
      point.residual = point.across - p - q * point.along;
      if (point.good) squares += point.residual * point.residual;
    }
    const float limit = std::max(tolerance, 3.0F * robust_sigma(points));
    bool changed = false;
    for (const EdgePoint& point : points) changed = changed || point.good != (std::abs(point.residual) <= limit);
    if (!changed || pass == kPasses) {
      const double variance = points_per_independent_one(points) * static_cast<double>(squares) /
                              std::max(1.0, static_cast<double>(n) - 2.0);
      line.p = static_cast<double>(p);
      line.q = static_cast<double>(q);
      line.rms = std::sqrt(static_cast<double>(squares / n));
      line.covariance << static_cast<double>(stt), -static_cast<double>(st), -static_cast<double>(st),
          static_cast<double>(n);
      line.covariance *= variance / static_cast<double>(determinant);
      break;
    }
    for (EdgePoint& point : points) point.good = std::abs(point.residual) <= limit;
  }
  return line;
}

}  // namespace markservo::target_locator
