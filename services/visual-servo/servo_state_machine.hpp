#pragma once

// The servo's core: goals, joint states and stop states are observed as they come; every TARGET_POSE yields one joint
// command and one status. No clock but the messages'.

#include <cstdint>
#include <optional>
#include <string>

#include "common/motion/goal_inbox.hpp"
#include "services/visual-servo/gripper_watch.hpp"
#include "services/visual-servo/joint_history.hpp"
#include "services/visual-servo/posture_motion.hpp"
#include "services/visual-servo/servo_by_sight.hpp"
#include "services/visual-servo/servo_types.hpp"
#include "services/visual-servo/still_target.hpp"

namespace markservo::visual_servo {

enum class Law { kResolvedRate, kPaper };

struct Parameters {
  Law law = Law::kResolvedRate;
  SightParameters sight;
  PostureMotionParameters posture;
  StillTargetParameters target;
  double pose_age = 0.2;   // s; a picture that is older than the joint states by more is not acted on
  double joint_age = 0.3;  // s; likewise joint states that are older than the picture
  // s; a goal that was not repeated for longer in the joint states' time has lost its sender. It is repeated every 0.2
  // s and bears the time of a picture, which may be pose_age old and come at intervals of up to 0.2 s.
  double goal_age = 0.6;
  double follow_lead = 0.7;     // rad; a command farther ahead of the arm waits: 0.4 s at full speed and some play
  double lost_arm = 0.052;      // rad (3 degrees); an arm that rests so far from its command is taken where it is
  double hand_mismatch = 0.04;  // m between the hand mark and where the joints say it is: another thing was seen
  double slow_down_factor =
      0.4;  // of the last step, per 1/30 s, once the arm must wait; never runs past a goal (gain 0.6)
  double slow_down_time = 0.12;  // s after which it stands
};

// All memory between messages.
struct State {
  JointHistory joints;
  std::optional<bool> stop_latched;  // nothing before the arm's first STOP_STATE
  std::string stop_reason;
  std::string blocked;  // why nothing may move though no stop is latched; empty when nothing speaks against it

  motion::GoalInbox goals{"SERVO_GOAL"};
  std::optional<Goal> goal;  // what goals.goal() asks for
  std::string goal_refusal;  // why the goal cannot be followed at all
  std::string dropped;       // why the last goal was dropped, until the next one

  bool commanded = false;
  bool adopt_joints = false;     // the command no longer belongs to this arm's state
  bool adopted_in_hold = false;  // an arm that rested elsewhere was taken where it was, since the goal began
  Command command;
  std::int64_t command_utime = 0;  // us, joints' clock, when command.position last changed
  std::int64_t gripper_utime = 0;  // us, likewise command.gripper_opening
  GripperWatch gripper;

  std::int64_t pose_utime = 0;
  std::int64_t frame_session = 0;
  double seconds = 1.0 / 30.0;                  // frame interval
  JointVector last_step = JointVector::Zero();  // rad, zero when it may be broken off at once
  double waiting = 0.0;                         // s since the motion was interrupted
  StillTarget target;
  SightState sight;
  int paper_frames = 0;  // in a row within tolerance, by the paper's law
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
  void adopt_gripper(State& state) const;
  std::string why_stale(const PoseSample& pose, const State& state) const;
  std::string why_goal_is_stale(const State& state) const;
  void follow_goal(const PoseSample& pose, State& state, Status& status) const;
  void hold(State& state) const { state.last_step.setZero(); }
  void slow_down(State& state) const;
  void move(const JointVector& step, bool at_once, bool streaming, State& state, Status& status) const;
  void move_to_posture(State& state, Status& status) const;
  void servo(const PoseSample& pose, State& state, Status& status) const;
  void servo_resolved_rate(const PoseSample& pose, const MarkSample& hand, State& state, Status& status) const;
  void servo_paper(const PoseSample& pose, const MarkSample& hand, State& state, Status& status) const;
  void set_gripper(const Goal& goal, State& state) const;
  void set_opening(double opening, State& state) const;
  double grip_speed_limit(const Goal& goal) const;

  robot::RobotDescription robot_;
  robot::ArmDescription arm_;
  std::string hand_name_;
  JointVector servo_speed_;  // rad/s, the servos' own
  Parameters parameters_;
};

}  // namespace markservo::visual_servo
