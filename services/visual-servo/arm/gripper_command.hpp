#pragma once

// What the gripper is commanded to: as a goal says, or what it is doing already. What was sent last, and whether the
// fingers press on something by it, are remembered here.

#include <cstdint>

#include "services/visual-servo/arm/gripper_watch.hpp"
#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

class GripperCommand {
 public:
  // Takes in one joint state; `obeying`: the arm does what is commanded (neither stopped nor to be taken up again).
  void observe(const JointSample& sample, bool obeying);

  // The gripper stays as it is: one that was moving does not go on, one that presses goes on pressing. Until a goal is
  // learned one that holds something presses with all its force.
  void adopt(const robot::GripperDescription& gripper, const JointSample& now);
  // What the goal asks for, as far as the gripper can. `now`: us, of the joints.
  void follow(const robot::GripperDescription& gripper, const Goal& goal, std::int64_t now);

  double opening() const { return opening_; }  // m
  double force() const { return force_; }      // N

 private:
  void set_opening(const robot::GripperDescription& gripper, double opening, std::int64_t now);

  bool begun_ = false;  // something has been commanded
  double opening_ = 0.0;
  double force_ = 0.0;
  std::int64_t since_ = 0;  // us, joints' clock, when opening_ last changed
  GripperWatch watch_;
};

}  // namespace markservo::visual_servo
