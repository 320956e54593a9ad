#pragma once

// The localiser's own structs as messages.

#include <markservo/channels.hpp>

#include "services/rfid-localizer/localizer.hpp"

namespace markservo::rfid_localizer {

EncoderReading encoder_reading(const WheelOdometry& message);
TagRound tag_round(const RfidTagHits& message);

// All but session, seq and the odometry's echo. `paper_pose`: the pose is the paper's compensated position and
// direction in place of the filter's.
RobotPose pose_message(const Estimate& estimate, std::int64_t utime, bool paper_pose);

}  // namespace markservo::rfid_localizer
