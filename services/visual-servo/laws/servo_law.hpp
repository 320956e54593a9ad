#pragma once

// What every law of servoing does: from what one frame shows of a SERVO goal to the next step of the command. A law
// itself remembers nothing; what it has to is in LawState (laws/law_state.hpp).

#include <Eigen/Core>
#include <string>

#include "services/visual-servo/arm/arm_command.hpp"
#include "services/visual-servo/arm/joint_history.hpp"
#include "services/visual-servo/servo_types.hpp"
#include "services/visual-servo/sight/hand_and_target.hpp"

namespace markservo::visual_servo {

struct LawState;

// What a law is told of one frame.
struct LawInput {
  const Goal& goal;  // kind servo, and not refused
  const Sighting& sighting;
  const JointHistory& joints;
  const ArmCommand& command;
  double seconds = 1.0 / 30.0;  // frame interval
  double grip_speed = 0.0;      // m/s, limit of the grip point, above 0

  // m, in C: the wanted grip point.
  Eigen::Vector3d p_CG_goal() const { return sighting.p_CT + goal.p_TG_C; }
};

struct LawAnswer {
  ArmStep step;
  bool converged = false;
  bool settled = false;
  int frames = 1;                                   // of the hand mark, behind `error`
  Eigen::Vector3d error = Eigen::Vector3d::Zero();  // m, in C, grip point minus goal
  std::string unreachable;                          // why; empty when it can be reached
};

class ServoLaw {
 public:
  virtual ~ServoLaw() = default;
  virtual LawAnswer step(const LawInput& input, LawState& state) const = 0;
};

}  // namespace markservo::visual_servo
