#pragma once

// Where a mask's pixels lie, and in what shape.

#include <Eigen/Core>
#include <array>

#include "services/target-locator/image/plane_image.hpp"

namespace markservo::target_locator {

// Calls visit(row, begin, end) for every run of the mask, by rows, then columns.
template <class Visit>
void for_each_run(const Mask& mask, const Visit& visit) {
  for (int y = mask.next_used(0); y < mask.height(); y = mask.next_used(y + 1)) {
    for (int begin = mask.next(y, 0, true); begin < mask.width();) {
      const int end = mask.next(y, begin, false);
      visit(y, begin, end);
      begin = mask.next(y, end, true);
    }
  }
}

// Central moments of a mask, per pixel. Patch px to the moment's power; all zero for an empty mask.
struct MaskMoments {
  double n = 0.0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  // column, row
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  std::array<double, 5> fourth{};  // of x^4, x^3 y, x^2 y^2, x y^3, y^4
};

MaskMoments moments_of(const Mask& mask);

}  // namespace markservo::target_locator
