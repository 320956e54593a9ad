#pragma once

#include "common/bus/bus.hpp"

namespace markservo::simulator {

class WorldNode;

// Lockstep: the world stands still until every awaited channel has answered the newest frame or odometry. Who never
// answered may still be starting; who did and then takes longer than `timeout_s` (above 0) makes the run invalid.
// Returns when the service shall end.
void run_lockstep(bus::Bus& bus, WorldNode& world, double timeout_s);

}  // namespace markservo::simulator
