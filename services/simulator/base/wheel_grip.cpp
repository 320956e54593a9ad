#include "services/simulator/base/wheel_grip.hpp"

#include <cmath>

namespace markservo::simulator {
namespace {

// m of way. A share per stretch, not noise per step: the true speed stays smooth and the step size does not matter.
constexpr double kSlipStretch = 0.10;
constexpr double kNoiseStretch = 0.02;

}  // namespace

double WheelGrip::roll(double turned) {
  if (turned == 0.0) return 0.0;
  if (travelled_ >= slip_until_) {
    slip_share_ = 2.0 * parameters_.slip * bits_.uniform();
    slip_until_ += kSlipStretch;
  }
  if (travelled_ >= noise_until_) {
    noise_share_ = parameters_.noise_per_sqrt_m / std::sqrt(kNoiseStretch) * bits_.gaussian();
    noise_until_ += kNoiseStretch;
  }
  travelled_ += std::abs(turned);
  return turned * (1.0 - slip_share_ + noise_share_);
}

}  // namespace markservo::simulator
