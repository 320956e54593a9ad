#pragma once

// The simulated base's plain structs as messages; session and seq are the publisher's.

#include <cstdint>
#include <markservo/channels.hpp>

#include "services/simulator/base/base_rig.hpp"
#include "services/simulator/readers/sonar_reading.hpp"

namespace markservo::simulator {

WheelOdometry odometry_message(const OdometryReading& odometry);

RfidTagHits rfid_message(const TagRound& round);

SonarScan sonar_message(const SonarReading& scan);

// The truth at the WHEEL_ODOMETRY with `utime` (us) and `odometry_seq`. Touches nothing and has nothing near: whoever
// knows of obstacles fills that in.
SimBaseTruth base_truth_message(const BaseTruth& truth, std::int64_t utime, std::int64_t odometry_seq);

}  // namespace markservo::simulator
