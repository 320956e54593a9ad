#pragma once

#include <cstdint>

#include "services/simulator/random.hpp"

namespace markservo::simulator {

struct WheelGripParameters {
  double slip = 0.0;              // mean share of the turning that makes no way, [0, 0.5]
  double noise_per_sqrt_m = 0.0;  // m per sqrt(m): random walk of the way
};

// What way a wheel makes on the floor as it turns; the floor differs from stretch to stretch.
class WheelGrip {
 public:
  WheelGrip(const WheelGripParameters& parameters, std::uint64_t seed) : parameters_(parameters), bits_(seed) {}

  // The true way (m) while the wheel turns by `turned` (m).
  double roll(double turned);

  double travelled() const { return travelled_; }  // m, both directions added up

 private:
  WheelGripParameters parameters_;
  RandomBits bits_;
  double travelled_ = 0.0;    // m, both directions added up
  double slip_until_ = 0.0;   // m travelled
  double noise_until_ = 0.0;  // m travelled
  double slip_share_ = 0.0;   // of this stretch
  double noise_share_ = 0.0;  // of this stretch
};

}  // namespace markservo::simulator
