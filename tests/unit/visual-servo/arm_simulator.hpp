#pragma once

// A kinematic arm with the faults of cheap servos, seen by noisy vision through a true arm that differs from the
// described one: what the servo core is tried on. Seeded; knows no clock but its own.

#include <deque>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "common/motion/command_path.hpp"
#include "services/simulator/arm/servo_model.hpp"
#include "services/visual-servo/decisions/servo_state_machine.hpp"

namespace markservo::visual_servo::test {

struct ServoFaults {
  std::string name;
  simulator::DeadbandKind deadband = simulator::DeadbandKind::kStopsAtEdge;
  double deadband_rad = 0.0;  // to each side
  double backlash_rad = 0.0;  // in all, half to each side
};

struct SimulatorSettings {
  ServoFaults servos;
  int delay_frames = 1;          // from exposure to servo
  bool delay_in_vision = false;  // the delay beyond one frame is spent before the core sees the pose, not after
  double frame_rate = 30.0;      // Hz
  double vision_sigma = 0.0002;  // m, per axis
  double base_error = 0.003;     // m, per axis, uniform: where the arm really stands
  double link_error = 0.01;      // part, uniform: how long its links really are
  double acceleration = 100.0;   // rad/s2 of the servos' motors
  bool measured = false;         // joint states show the shafts
};

class ArmSimulator {
 public:
  ArmSimulator(const robot::RobotDescription& robot, const SimulatorSettings& settings, std::uint64_t seed);

  // Puts shafts and ramps at `q` and the target's mark at `p_CT`.
  void place(const JointVector& q, const Eigen::Vector3d& p_CT);
  void move_target(const Eigen::Vector3d& p_CT) { p_CT_ = p_CT; }

  // Exposes a frame and returns the one that vision is done with (the first few times: the first one).
  PoseSample expose();
  // Joint states since the last call.
  std::deque<JointSample> take_joint_states();
  // Hands over the command and runs on to the next exposure.
  void finish_frame(const std::optional<Command>& command);

  Eigen::Vector3d grip_point() const;  // m, true
  // Largest excess of the true grip point beyond y, m, since place().
  double deepest_y() const { return deepest_y_; }
  // Largest distance of the true grip point from the line start - goal, m, since place().
  double largest_sweep(const Eigen::Vector3d& goal) const;
  // Commands so far that a driver would refuse for jumping away from those before them.
  int jumps() const { return jumps_; }
  double time() const { return time_; }
  std::int64_t utime() const;  // us, of time()
  bool hide_hand = false;
  bool hide_target = false;

  // The gripper: it closes no further than what is between the fingers.
  double opening = 0.05;      // m, as measured
  double object_width = 0.0;  // m
  bool stopped = false;       // STOP is latched: joints and gripper stay where they are and obey nothing

 private:
  struct Pending {
    double due;
    Command command;
  };
  void run_until(double time);
  void tick();
  void report_joints();
  simulator::ServoParameters servo(int joint) const;
  JointVector ramps() const;
  JointVector shafts() const;
  Eigen::Vector3d noise();

  robot::RobotDescription robot_;
  robot::ArmDescription truth_;
  SimulatorSettings settings_;
  std::mt19937_64 random_;
  double time_ = 0.0;
  double frame_time_ = 0.0;
  double next_state_ = 0.0;
  std::deque<PoseSample> poses_;
  std::deque<Pending> pending_;
  std::deque<JointSample> states_;
  motion::CommandPath commanded_;
  int jumps_ = 0;
  double opening_target_ = 0.05;
  std::vector<simulator::ServoModel> joints_;
  Eigen::Vector3d p_CT_ = Eigen::Vector3d::Zero();
  double deepest_y_ = -1e9;
  std::vector<Eigen::Vector3d> path_;
};

}  // namespace markservo::visual_servo::test
