#include "tests/experiments/localisation/described_wheels.hpp"

#include <gtest/gtest.h>

namespace markservo::experiments {
namespace {

robot::BaseDescription base() {
  robot::BaseDescription base;
  base.track = 0.4;
  base.scale_sigma = 0.03;
  base.drift = 0.1;
  base.pivot_wander = 0.02;
  return base;
}

TEST(DescribedWheels, ErrAsTheRobotsDescriptionStates) {
  const simulator::BaseModelParameters wheels = wheels_as_stated(base());
  EXPECT_EQ(wheels.scale_sigma, 0.03);
  EXPECT_EQ(wheels.drift, 0.1);
  EXPECT_EQ(wheels.pivot_wander, 0.02);
  EXPECT_EQ(wheels.slip, 0.0);
}

TEST(DescribedWheels, AreToldToTheBoundAsTheyErr) {
  const EncoderNoise noise = encoder_noise(wheels_as_stated(base()), base().track);
  EXPECT_EQ(noise.scale_sigma, 0.03);
  EXPECT_EQ(noise.heading_drift, 0.1);
  EXPECT_DOUBLE_EQ(noise.along, 0.02) << "m per sqrt(m), of two wheels that err on their own";
  EXPECT_EQ(noise.pivot_wander, 0.02);
}

}  // namespace
}  // namespace markservo::experiments
