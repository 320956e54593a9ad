#pragma once

namespace markservo::mmi {

// s without a word of a stop device, 5 of which come a second, after which it counts as silent: a loaded machine delays
// one by 1 to 2 s.
inline constexpr double kDeviceSilence = 2.5;

}  // namespace markservo::mmi
