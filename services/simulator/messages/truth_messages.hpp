#pragma once

#include <markservo/channels.hpp>

#include "services/simulator/world/world_truth.hpp"

namespace markservo::simulator {

// Fills in all but the message's and the frame's identity and the echo of SIM_CONTROL.
SimTruth truth_message(const WorldTruth& truth);

}  // namespace markservo::simulator
