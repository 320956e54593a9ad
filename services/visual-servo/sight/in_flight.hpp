#pragma once

// Where the grip point was at the exposure, by sight, and where it will be once everything commanded has been carried
// out: the motion that the picture does not show yet is added from the joints, so no delay needs to be known.

#include <Eigen/Core>

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

// Grip point G in C (m) from the hand mark's measured centre `p_CM` (m) and the joints at the exposure, which give the
// forearm's direction: p_CG = p_CM - R_CG p_GM. The arm's position errors cancel; only its direction counts.
Eigen::Vector3d seen_grip_point(const robot::ArmDescription& arm, const robot::JointVector& q_exposure,
                                const Eigen::Vector3d& p_CM);

// What sight adds to the joints' word (m): the seen grip point minus the kinematic one at the exposure. Calibration,
// deadband and backlash all show in it.
Eigen::Vector3d kinematic_bias(const robot::ArmDescription& arm, const robot::JointVector& q_exposure,
                               const Eigen::Vector3d& p_CM);

// Grip point in C (m) once the joints have reached `q_command`.
Eigen::Vector3d predicted_grip_point(const robot::ArmDescription& arm, const robot::JointVector& q_command,
                                     const Eigen::Vector3d& bias);

}  // namespace markservo::visual_servo
