#pragma once

// The posture that the arm is commanded to: moved on by a step a frame, held, brought gently to rest, or taken from
// where the shafts are. What was sent last is remembered here; what to send is decided elsewhere.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "services/visual-servo/arm/joint_history.hpp"
#include "services/visual-servo/arm/settling.hpp"
#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

struct ArmCommandParameters {
  double follow_lead = 0.7;  // rad; a command farther ahead of the arm waits: 0.4 s at full speed and some play
  // The part of the last step that each 1/30 s still makes once the arm must wait; never runs past a goal (gain 0.6).
  double slow_down_factor = 0.4;
  double slow_down_time = 0.12;  // s after which it stands
};

// A change of the commanded posture.
struct ArmStep {
  JointVector change = JointVector::Zero();  // rad
  bool streaming = false;                    // one of many: slow down gently if the next cannot follow
  // rad/s, each joint's limit in a step that is not streaming; infinite: the step is made at once. The servos' own
  // speeds bound it.
  double joint_speed = std::numeric_limits<double>::infinity();
};

class ArmCommand {
 public:
  // Something has been commanded.
  bool begun() const { return begun_; }
  // The command no longer belongs to the arm's state: it is to be taken from the shafts before anything moves.
  bool adoption_due() const { return adoption_due_; }
  void require_adoption() { adoption_due_ = true; }

  // Takes the posture of the shafts: nothing moves by it.
  void adopt(const JointSample& now);
  // The posture stays, and nothing is left to slow down from.
  void hold() { last_step_.setZero(); }
  // Goes on by a smaller part of the last step each frame, until the arm stands. `now`: us, of the joints; `seconds`:
  // frame interval.
  void slow_down(const robot::ArmDescription& arm, const ArmCommandParameters& parameters, std::int64_t now,
                 double seconds);
  // Makes the step, unless the command would lead the shafts too far: then it stays, and the answer says which joint
  // does not follow. Empty when the step was made.
  std::string move(const robot::ArmDescription& arm, const ArmCommandParameters& parameters, const ArmStep& step,
                   const JointSample& now, double seconds);

  // Lowers the speed limit of an arm that rests: a command that is forged in this service's name is then believed for
  // no large step.
  void relax(const SettlingParameters& parameters, const JointHistory& joints);

  const JointVector& position() const { return position_; }        // rad
  const JointVector& speed_limit() const { return speed_limit_; }  // rad/s
  const JointVector& last_step() const { return last_step_; }      // rad, zero when it may be broken off at once

  // The utime since which all that was commanded has been carried out; nothing while something is in flight.
  std::optional<std::int64_t> at_rest_since(const SettlingParameters& parameters, const JointHistory& joints) const;
  // Whether at `utime` (us) the shafts had been at rest for long enough to be judged.
  bool settled_at(const SettlingParameters& parameters, const JointHistory& joints, std::int64_t utime) const;

 private:
  bool begun_ = false;
  bool adoption_due_ = false;
  JointVector position_ = JointVector::Zero();
  JointVector speed_limit_ = JointVector::Zero();
  std::int64_t since_ = 0;  // us, joints' clock, when position_ last changed
  JointVector last_step_ = JointVector::Zero();
  double waiting_ = 0.0;  // s since the motion was interrupted
};

}  // namespace markservo::visual_servo
