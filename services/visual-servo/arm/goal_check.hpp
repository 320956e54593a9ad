#pragma once

// Whether the arm can do what is asked, with the reason in words when it cannot. Empty means yes.

#include <string>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

// A goal whose numbers make sense: finite, known kind, as many joints as the arm has, joints within their limits, a
// target that robot.yaml knows.
std::string why_goal_is_refused(const robot::RobotDescription& robot, const Goal& goal);

// A grip point (m, in C) that the arm reaches with every joint `margin` (rad) inside its limits; says which joint or
// axis forbids it. `q` receives the joints when it can.
std::string why_unreachable(const robot::ArmDescription& arm, const Eigen::Vector3d& p_CG, double margin,
                            JointVector& q);

}  // namespace markservo::visual_servo
