#pragma once

// An ellipse as a contour that can be fitted: what a camera sees of a disc or a ball.

#include <Eigen/Core>

#include "services/target-locator/contour/coverage.hpp"

namespace markservo::target_locator {

// The points p with (p - centre)' M^-1 (p - centre) = 1. Parameters: the centre's column and row, and M's xx, xy and
// yy: under an affine map T of the image M becomes T M T'. Patch px.
class EllipseContour {
 public:
  static constexpr int kSize = 5;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  EllipseContour(const Eigen::Vector2d& centre, const Eigen::Matrix2d& shape);

  // What a pixel at (x, y) shows of it. The outline counts as straight within the blur's reach, which makes it too
  // small by blur^2 / (2 radius) all around.
  Coverage at(double x, double y, double blur) const;
  double perimeter() const;
  // Whether it is of some size, and no line.
  bool is_sane() const;
  void change(const Vector& by);

  const Vector& parameters() const { return parameters_; }

 private:
  void prepare();

  Vector parameters_;
  Eigen::Matrix2d inverse_;  // of M
};

}  // namespace markservo::target_locator
