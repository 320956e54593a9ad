#pragma once

// The paper's control law (paper eq. 6), kept as the baseline: each joint follows one axis of the marks' difference.

#include <Eigen/Core>

#include "common/robot/robot_description.hpp"
#include "services/visual-servo/laws/servo_law.hpp"

namespace markservo::visual_servo {

// What the law brings to zero (m, in C): hand mark minus the target mark with its constant offset. `shift_TG` (m) is
// the wanted grip point minus the target's usual one, so that goals other than the grip can be served.
Eigen::Vector3d paper_error(const robot::PaperLawDescription& law, const Eigen::Vector3d& p_CM,
                            const Eigen::Vector3d& p_CT, const Eigen::Vector3d& shift_TG);

// Joint step (rad) of one frame interval `seconds`: gain (rad/s per m, signed) times error (paper eq. 6), each joint no
// faster than `joint_speed` (rad/s).
robot::JointVector paper_step(const robot::PaperLawDescription& law, const Eigen::Vector3d& error, double seconds,
                              double joint_speed);

// The parameters have no defaults: they are those of the law by sight, so that both are compared alike.
struct PaperParameters {
  double tolerance = 0.0;     // m, when the goal states none
  int frames = 0;             // in a row within tolerance, after which it has converged
  double joint_speed = 0.0;   // rad/s, limit of each joint
  double joint_margin = 0.0;  // rad from limits and from the stretched arm, for goals
};

struct PaperState {
  int frames = 0;  // in a row within tolerance
};

class PaperLaw : public ServoLaw {
 public:
  // `robot` has an arm. Throws std::invalid_argument unless it has a paper_law.
  PaperLaw(robot::RobotDescription robot, const PaperParameters& parameters);
  LawAnswer step(const LawInput& input, LawState& state) const override;

 private:
  robot::RobotDescription robot_;
  PaperParameters parameters_;
};

}  // namespace markservo::visual_servo
