#pragma once

// A quadrangle as a contour that can be fitted: four straight sides.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "services/target-locator/contour/coverage.hpp"
#include "services/target-locator/outline/image_line.hpp"

namespace markservo::target_locator {

// Parameters 2 k and 2 k + 1 move side k outwards and turn it, about where it was at the beginning. Patch px.
class QuadContour {
 public:
  static constexpr int kSize = 8;
  using Vector = Eigen::Matrix<double, kSize, 1>;

  // Makes the quadrangle of four lines with normals outwards, line k + 1 following line k around. Nothing when they
  // enclose none.
  static std::optional<QuadContour> from_lines(const Lines& lines);

  // What a pixel at (x, y) shows of it. Beside corners the coverages of both sides are multiplied, which is exact for
  // right angles.
  Coverage at(double x, double y, double blur) const;
  double perimeter() const;
  // Whether it is convex and of some size.
  bool is_sane() const;
  void change(const Vector& by) { parameters_ += by; }

  const Vector& parameters() const { return parameters_; }
  std::optional<Corners> corners() const;

 private:
  struct Side {
    Eigen::Vector2d middle;
    Eigen::Vector2d outward;  // unit
    Eigen::Vector2d along;    // unit, from one corner to the next
    double length = 0.0;
  };

  std::array<Side, 4> sides_;
  Vector parameters_ = Vector::Zero();
};

}  // namespace markservo::target_locator
