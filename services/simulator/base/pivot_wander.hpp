#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "services/simulator/random.hpp"

namespace markservo::simulator {

// Where castors and tyres push a base while it turns: a random walk with the root of the angle, each axis for itself.
class PivotWander {
 public:
  // `per_sqrt_rad`: m per sqrt(rad), from 0 up.
  PivotWander(double per_sqrt_rad, std::uint64_t seed) : per_sqrt_rad_(per_sqrt_rad), bits_(seed) {}

  // m in W, while the wheels turn the base by `turn` (rad).
  Eigen::Vector2d turn(double turn);

  double turned() const { return turned_; }  // rad, both directions added up

 private:
  double per_sqrt_rad_;
  RandomBits bits_;
  double turned_ = 0.0;
  double until_ = 0.0;                              // rad turned
  Eigen::Vector2d push_ = Eigen::Vector2d::Zero();  // m per rad, of this stretch
};

}  // namespace markservo::simulator
