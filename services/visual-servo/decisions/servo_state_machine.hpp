#pragma once

// The servo's core: goals, joint states and stop states are observed as they come; every TARGET_POSE yields one joint
// command and one status. No clock but the messages'.

#include <memory>
#include <string>

#include "common/motion/goal_inbox.hpp"
#include "services/visual-servo/arm/arm_command.hpp"
#include "services/visual-servo/arm/gripper_command.hpp"
#include "services/visual-servo/arm/joint_history.hpp"
#include "services/visual-servo/decisions/followed_goal.hpp"
#include "services/visual-servo/decisions/lost_arm.hpp"
#include "services/visual-servo/decisions/motion_enable.hpp"
#include "services/visual-servo/decisions/picture_clock.hpp"
#include "services/visual-servo/laws/law_state.hpp"
#include "services/visual-servo/laws/posture_motion.hpp"
#include "services/visual-servo/laws/servo_by_sight.hpp"
#include "services/visual-servo/laws/servo_law.hpp"
#include "services/visual-servo/servo_types.hpp"
#include "services/visual-servo/sight/hand_and_target.hpp"

namespace markservo::visual_servo {

enum class Law { kResolvedRate, kPaper };

struct Parameters {
  Law law = Law::kResolvedRate;
  SightParameters sight;
  PostureMotionParameters posture;
  HandAndTargetParameters marks;
  ArmCommandParameters command;
  double pose_age = 0.2;   // s; a picture that is older than the joint states by more is not acted on
  double joint_age = 0.3;  // s; likewise joint states that are older than the picture
  // s; a goal that was not repeated for longer in the joint states' time has lost its sender. It is repeated every 0.2
  // s and bears the time of a picture, which may be pose_age old and come at intervals of up to 0.2 s.
  double goal_age = 0.6;
  double lost_arm = 0.052;  // rad (3 degrees); an arm that rests so far from its command is taken where it is
};

// All memory between messages.
struct State {
  JointHistory joints;
  MotionEnable enable;
  FollowedGoal followed;
  LostArm lost;
  PictureClock pictures;
  ArmCommand command;
  GripperCommand gripper;
  HandAndTarget marks;
  LawState law;
};

class ServoStateMachine {
 public:
  // `robot` must have an arm and one mark of role manipulator, and a paper_law when the law is the paper's; throws
  // std::invalid_argument otherwise.
  ServoStateMachine(robot::RobotDescription robot, Parameters parameters);

  // Refuses (false) what is not finite.
  bool observe(const JointSample& sample, State& state) const;
  // What became of a goal, new or repeated.
  motion::GoalHeard observe(const Goal& goal, State& state) const;
  // The arm's STOP_STATE. Latched: the present goal ends.
  void observe_stop(bool latched, const std::string& reason, State& state) const;
  // The arm is another one, or its clock began anew: the joints' history and the goal are forgotten. `why` for people.
  void begin_anew(const std::string& why, State& state) const;
  // The pictures are of another writer, or their clock began anew.
  void begin_pictures_anew(State& state) const;

  Output step(const PoseSample& pose, State& state) const;

 private:
  void advance_time(const PoseSample& pose, State& state) const;
  void adopt_joints(State& state) const;
  std::string why_stale(const PoseSample& pose, const State& state) const;
  void follow_goal(const PoseSample& pose, State& state, Status& status) const;
  // Why an arm that rests elsewhere is left there; empty when it does not, or has been taken where it is.
  std::string adopt_lost_arm(State& state) const;
  void slow_down(State& state) const;
  void move(const ArmStep& step, State& state, Status& status) const;
  void move_to_posture(State& state, Status& status) const;
  void servo(const PoseSample& pose, State& state, Status& status) const;
  double grip_speed_limit(const Goal& goal) const;

  robot::RobotDescription robot_;
  robot::ArmDescription arm_;
  std::string hand_name_;
  Parameters parameters_;
  std::unique_ptr<const ServoLaw> law_;
};

}  // namespace markservo::visual_servo
