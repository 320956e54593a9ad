#include "tests/experiments/localisation/described_wheels.hpp"

namespace markservo::experiments {

simulator::BaseModelParameters wheels_as_stated(const robot::BaseDescription& base) {
  simulator::BaseModelParameters wheels;
  wheels.scale_sigma = base.scale_sigma;
  wheels.drift = base.drift;
  wheels.pivot_wander = base.pivot_wander;
  return wheels;
}

EncoderNoise encoder_noise(const simulator::BaseModelParameters& wheels, double track) {
  EncoderNoise noise;
  noise.scale_sigma = wheels.scale_sigma;
  noise.heading_drift = wheels.drift;
  noise.along = 0.5 * wheels.drift * track;
  noise.pivot_wander = wheels.pivot_wander;
  return noise;
}

}  // namespace markservo::experiments
