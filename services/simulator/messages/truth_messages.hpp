#pragma once

#include <markservo/channels.hpp>

#include "services/simulator/world/world_truth.hpp"

namespace markservo::simulator {

// All but the message's and the frame's identity and the control echo.
SimTruth truth_message(const WorldTruth& truth);

}  // namespace markservo::simulator
