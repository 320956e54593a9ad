#pragma once

#include <cstdint>

namespace markservo::simulator {

// The time step of the MuJoCo model, and of all that goes along with it.
inline constexpr double kTimeStep = 0.002;  // s
inline constexpr std::int64_t kTimeStep_us = 2'000;

static_assert(kTimeStep_us == static_cast<std::int64_t>(kTimeStep * 1e6));

}  // namespace markservo::simulator
