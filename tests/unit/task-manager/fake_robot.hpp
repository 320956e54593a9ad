#pragma once

// A kinematic stand-in for arm, base, cameras, visual-servo and base-navigator that drives the procedure's core:
// postures are reached after some frames, servoing converges, a gripped book follows the hand, the base slides to its
// goal. A phase that does not follow from the one before (common/task/transitions.hpp) fails the test.

#include <Eigen/Geometry>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "services/task-manager/procedure.hpp"

namespace markservo::task_manager {

// config/robot.yaml.
robot::RobotDescription default_robot();

class FakeRobot {
 public:
  FakeRobot();
  explicit FakeRobot(const robot::RobotDescription& description, const Parameters& parameters = Parameters());

  // What a test may set at any time.
  Eigen::Vector3d p_CT{0.0325, 0.25, 0.032};  // m, the red book's mark
  Sight target_sight = Sight::kLocated;       // unless out of view
  Sight hand_sight = Sight::kLocated;
  int slips = 0;                    // so many grips do not hold
  bool follows_goals = true;        // false: visual-servo is silent about our goals
  std::int64_t forged_goal_id = 0;  // of a goal that another sent in our name: visual-servo follows it instead
  bool stale = false;
  bool arm_answers = true;
  std::string unreachable;  // servoing cannot go on, and why
  StopReport stop{true, false, ""};
  std::int64_t arm_session = 7;
  geometry::PlanePose base_pose{0.2, 0.05, M_PI / 2};  // X_WR
  bool base_answers = true;                            // false: no BASE_STATUS any more
  std::optional<BaseState> base_stuck;                 // what base-navigator says instead of driving
  std::string base_reason;
  double base_drift = 0.0;  // m, by which it stops short of a goal in W

  // START with a drive.
  void send_drive(const geometry::PlanePose& pose, const std::string& target = "red_book");
  void send_drive_only(const geometry::PlanePose& pose);
  void send(CommandKind kind, const std::string& target = "", bool carry = false);
  void send_again();                  // the last command, repeated
  void send_again(CommandKind kind);  // another one under the last one's id

  // One frame.
  Output frame();
  // Frames until `phase`, at most `seconds`; true when it came.
  bool run_until(Phase phase, double seconds = 60.0);
  void run_for(double seconds);
  // The simulated world begins anew: book and arm are where they were, the hand is open.
  void reset_world();
  // A person moves the arm.
  void push_arm_to(const robot::JointVector& q) { q_ = q; }
  // task-manager dies and comes back.
  void restart_task_manager();

  const Output& last() const { return last_; }
  const Goal& goal() const { return goal_; }
  const robot::JointVector& q() const { return q_; }
  double opening() const { return opening_; }
  bool holds_book() const { return attached_; }
  double lifted() const { return p_CT.z() - start_.z(); }  // m
  Eigen::Vector3d grip_point() const;
  double way_of_joints() const { return way_; }                 // rad, all that the arm ever moved
  const std::vector<Phase>& phases() const { return phases_; }  // each as it was entered
  // What an open hand may not do: "" or where a finger was among the books off the line of approach.
  const std::string& trespass() const { return trespass_; }
  int goals_sent() const { return goals_sent_; }
  const DriveGoal& drive_goal() const { return drive_goal_; }
  int drive_goals_sent() const { return drive_goals_sent_; }
  double way_of_base() const { return way_of_base_; }  // m, all that it ever drove
  // What a base may not do: "" or how the arm stood while it drove, or in which phase.
  const std::string& reckless() const { return reckless_; }
  std::int64_t period_us = 33'333;  // of frames
  // So long no frame comes, and the robot stands: its goals have aged, which its first reports then tell.
  void blind_for(double seconds);
  double seconds() const { return 1e-6 * static_cast<double>(utime_); }

 private:
  void move_base();
  std::optional<BaseReport> base_report() const;
  void move_arm();
  void move_gripper();
  void look_for_trespass();
  ServoReport report();
  bool in_view(const Eigen::Isometry3d& X_CM, double size) const;
  void note(Phase phase);

  robot::RobotDescription robot_;
  Procedure procedure_;
  State state_;
  Output last_;
  Goal goal_;
  std::vector<Command> commands_;
  Command command_;
  std::int64_t next_command_ = 1;
  std::int64_t utime_ = 1'000'000;
  int frames_of_old_goals_ = 0;

  robot::JointVector q_;
  double opening_ = 0.05;
  bool attached_ = false;
  bool slipped_ = false;
  Eigen::Vector3d p_GT_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();  // of the book
  Eigen::Vector3d error_ = Eigen::Vector3d::Zero();
  double way_ = 0.0;
  int goals_sent_ = 0;
  DriveGoal drive_goal_;
  geometry::PlanePose base_goal_;  // X_WR
  int drive_goals_sent_ = 0;
  double way_of_base_ = 0.0;
  std::string reckless_;
  std::optional<BaseReport> base_said_;
  std::vector<Phase> phases_;
  std::string trespass_;
};

}  // namespace markservo::task_manager
