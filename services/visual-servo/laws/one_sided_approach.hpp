#pragma once

// Coming to the goal from one side, against deadband and backlash. A joint that ends every move in the same direction
// leaves its play on the same side, and a last move larger than the deadband makes every servo start: then what a
// correction changes in the command, it changes at the shaft.
// The shoulder ends lowering and the elbow ends raising: their lags cancel in the forearm's pitch, which sight of one
// mark does not show, and backing off draws the grip point back (-y) instead of up or down or into the object.

#include "common/robot/robot_description.hpp"

namespace markservo::visual_servo {

using robot::JointVector;

struct OneSidedParameters {
  double back_off = 0.030;    // rad (1.7 degrees): 1 degree of backlash and 0.3 degrees of deadband to each side
  double sure_move = 0.0087;  // rad (0.5 degrees): a move this large starts a servo with 0.3 degrees of deadband
  double last_move =
      0.00785;  // rad (0.45 degrees): starts that servo too, and is short enough to be one step of its
                // pulse: a servo that runs home then does not stop on the way, with the rest inside its deadband
  double refined_part = 0.2;   // of the last move: what later frames may still change it by (0.1 degrees, 0.5 mm at the
                               // grip point), so that it starts the servo and is one step all the same
  double unchanged = 0.00035;  // rad (0.02 degrees, 0.1 mm): joints that are nearer to their goal are left alone
};

// The direction, +1 or -1, in which each joint shall end its moves: yaw as it comes, shoulder lowering, elbow raising.
JointVector ending_directions(const JointVector& q_now, const JointVector& q_goal);

// The posture from which the goal is entered, within the joint limits, rad.
JointVector entry_posture(const robot::ArmDescription& arm, const OneSidedParameters& parameters,
                          const JointVector& q_goal, const JointVector& directions);

// A change of the commanded posture and the way to it.
struct Correction {
  JointVector via = JointVector::Zero();    // rad, backed off; equals the start when no backing off is needed
  JointVector final = JointVector::Zero();  // rad
  bool backs_off = false;
};

// The posture one last move before `q_final`, for a hand that enters from `q_command`, rad.
JointVector last_but_one(const OneSidedParameters& parameters, const JointVector& q_command, const JointVector& q_final,
                         const JointVector& directions);

// The correction that changes the command by `change` (rad) and enters it in `directions`.
Correction plan_correction(const robot::ArmDescription& arm, const OneSidedParameters& parameters,
                           const JointVector& q_command, const JointVector& change, const JointVector& directions);

}  // namespace markservo::visual_servo
