#pragma once

#include "common/robot/robot_description.hpp"
#include "services/rfid-localizer/localizer.hpp"

namespace markservo::rfid_localizer {

// On robot.yaml's drift of the heading: what floors add to it. Keeps the covariance honest at 5% of slip.
inline constexpr double kSlipMargin = 1.3;

// What `robot` says of its reader, tags and wheels, the rest as it is by default. A robot without base has no wheels.
// Its rfid and floor_tags must be described.
LocalizerParameters parameters_of(const robot::RobotDescription& robot, double slip_margin = kSlipMargin);

}  // namespace markservo::rfid_localizer
