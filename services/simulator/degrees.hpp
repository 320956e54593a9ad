#pragma once

// Factors for what settings and MJCF have in degrees. Not common/geometry's functions, which round the last bit
// otherwise: a seed shall give the world that it always gave.

namespace markservo::simulator {

inline constexpr double kRadiansPerDegree = 0.017453292519943295;
inline constexpr double kDegreesPerRadian = 57.29577951308232;

}  // namespace markservo::simulator
