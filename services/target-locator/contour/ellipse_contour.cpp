#include "services/target-locator/contour/ellipse_contour.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace markservo::target_locator {
namespace {

constexpr double kSmallestAxis_px = 3.0;  // half of it, below which the blur of both sides meets

}  // namespace

EllipseContour::EllipseContour(const Eigen::Vector2d& centre, const Eigen::Matrix2d& shape) {
  parameters_ << centre.x(), centre.y(), shape(0, 0), shape(0, 1), shape(1, 1);
  prepare();
}

void EllipseContour::prepare() {
  Eigen::Matrix2d shape;
  shape << parameters_[2], parameters_[3], parameters_[3], parameters_[4];
  inverse_ = shape.inverse();
}

void EllipseContour::change(const Vector& by) {
  parameters_ += by;
  prepare();
}

Coverage EllipseContour::at(double x, double y, double blur) const {
  const Eigen::Vector2d off(x - parameters_[0], y - parameters_[1]);
  const Eigen::Vector2d w = inverse_ * off;
  const double radius = std::sqrt(std::max(0.0, off.dot(w)));  // 1 on the ellipse
  const double steepness = w.norm();                           // of radius, times radius
  Coverage coverage;
  coverage.around = std::atan2(off.y(), off.x()) / (2.0 * M_PI) + 0.5;
  if (!(radius > 1e-6)) {
    coverage.distance = std::sqrt(std::min(parameters_[2], parameters_[4]));
    coverage.share = 1.0;
    return coverage;
  }
  coverage.distance = (1.0 - radius) * radius / steepness;
  const double a = w.x() / steepness;
  const double b = w.y() / steepness;
  const BlurredEdge edge(coverage.distance, blur, a, b);
  coverage.share = edge.share;
  coverage.by_distance = edge.by_distance;
  coverage.by_blur = edge.by_blur;
  if (edge.by_distance <= 0.0) return coverage;
  coverage.by_shape[0] = edge.by_distance * a;
  coverage.by_shape[1] = edge.by_distance * b;
  coverage.by_shape[2] = edge.by_distance * 0.5 * a * w.x();
  coverage.by_shape[3] = edge.by_distance * a * w.y();
  coverage.by_shape[4] = edge.by_distance * 0.5 * b * w.y();
  return coverage;
}

double EllipseContour::perimeter() const {
  return 2.0 * M_PI * std::sqrt(0.5 * (parameters_[2] + parameters_[4]));
}

bool EllipseContour::is_sane() const {
  if (!parameters_.allFinite() || !inverse_.allFinite()) return false;
  const double mean = 0.5 * (parameters_[2] + parameters_[4]);
  const double apart = std::hypot(0.5 * (parameters_[2] - parameters_[4]), parameters_[3]);
  return mean - apart > kSmallestAxis_px * kSmallestAxis_px;
}

}  // namespace markservo::target_locator
