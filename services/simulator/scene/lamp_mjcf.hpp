#pragma once

#include <cstdint>
#include <string>

#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

// The scene's lamps as MuJoCo's MJCF, brightness and direction varied by the seed: `vary` 0 (not at all) to 1.
std::string lamps(const LightScene& light, double vary, std::uint64_t seed);

}  // namespace markservo::simulator
