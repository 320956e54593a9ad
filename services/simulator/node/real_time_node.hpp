#pragma once

#include "common/bus/bus.hpp"

namespace markservo::simulator {

class WorldNode;

// Real time: the world goes along with this host's steady clock. Returns when the service shall end.
void run_real_time(bus::Bus& bus, WorldNode& world);

}  // namespace markservo::simulator
