#include "services/target-locator/image/texture_strength.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

namespace markservo::target_locator {
namespace {

// value = c0 + c1 x + c2 y over the mask, by least squares; zero where that is not fixed.
Eigen::Vector3d rise_over(const PlaneImage& image, const Mask& mask) {
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
  for (int y = mask.next_used(0); y < mask.height(); y = mask.next_used(y + 1)) {
    for (int x = mask.next(y, 0, true); x < mask.width(); x = mask.next(y, x + 1, true)) {
      const Eigen::Vector3d row(1.0, x, y);
      products += row * row.transpose();
      values += row * static_cast<double>(image.at(x, y));
    }
  }
  const Eigen::Vector3d rise = products.fullPivLu().solve(values);
  return rise.allFinite() ? rise : Eigen::Vector3d::Zero();
}

}  // namespace

double texture_strength(const PlaneImage& image, const Mask& mask) {
  const Eigen::Vector3d rise = rise_over(image, mask);
  double products = 0.0;
  double pairs = 0.0;
  for (int y = mask.next_used(0); y < mask.height(); y = mask.next_used(y + 1)) {
    for (int x = mask.next(y, 0, true); x + 1 < mask.width(); x = mask.next(y, x + 1, true)) {
      if (!mask.test(x + 1, y)) continue;
      const double here = static_cast<double>(image.at(x, y)) - rise.dot(Eigen::Vector3d(1.0, x, y));
      const double next = static_cast<double>(image.at(x + 1, y)) - rise.dot(Eigen::Vector3d(1.0, x + 1, y));
      products += here * next;
      pairs += 1.0;
    }
  }
  constexpr double kLeastPairs = 16.0;
  return pairs >= kLeastPairs && products > 0.0 ? std::sqrt(products / pairs) : 0.0;
}

}  // namespace markservo::target_locator
