#pragma once

// Where the robot may be told to drive: over the field of floor tags, by which alone it knows where it is.

#include <string>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::task_manager {

// Why a robot at `X_WR` would not find its way back: no tag of the field `field` (empty: the one in use) is below it.
// The field is the rectangle around its tags and as much as the reader reads beside it. Empty where it may stand, and
// where the robot's description has no tags. Throws ConfigurationError if there is no such field.
std::string why_off_the_field(const robot::RobotDescription& robot, const std::string& field,
                              const geometry::PlanePose& X_WR);

}  // namespace markservo::task_manager
