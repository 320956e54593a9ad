#pragma once

// How fast one may go and still stop in time, and how fast the speed may change. For m and m/s as well as rad and
// rad/s.

namespace markservo::base_navigator {

// The greatest speed from which one stops within `distance`: `reaction` s go by at that speed, then it falls by
// `braking` per second. 0 where distance is 0 or less. braking and reaction are above 0.
double stopping_speed(double distance, double braking, double reaction);

// The distance in which one stops from `speed`: the inverse of the above.
double stopping_distance(double speed, double braking, double reaction);

// The speed `seconds` after `from` on the way to `target`: it grows by `acceleration` per second at most, and falls
// towards 0 by `braking`; it does not change its sign within one step.
double ramped(double from, double target, double acceleration, double braking, double seconds);

}  // namespace markservo::base_navigator
