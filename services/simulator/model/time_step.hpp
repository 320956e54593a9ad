#pragma once

namespace markservo::simulator {

inline constexpr double kTimeStep = 0.002;  // s, of the MuJoCo model

}  // namespace markservo::simulator
