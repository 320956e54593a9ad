#pragma once

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_model.hpp"
#include "tests/experiments/localisation/fisher_bound.hpp"

namespace markservo::experiments {

// Wheels that err as the robot's description states, and do not slip.
simulator::BaseModelParameters wheels_as_stated(const robot::BaseDescription& base);

// The noise of such wheels, `track` (m) apart, as the bound is told it.
EncoderNoise encoder_noise(const simulator::BaseModelParameters& wheels, double track);

}  // namespace markservo::experiments
