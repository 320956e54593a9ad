#pragma once

// The gripper in the MuJoCo model: one motor opens and closes both fingers, at a limited speed and force.

#include <Eigen/Core>
#include <array>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm_command.hpp"
#include "services/simulator/arm/gripper_settings.hpp"
#include "services/simulator/model/joint_address.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class Gripper {
 public:
  // Puts the fingers of `data` to `opening` (m).
  Gripper(const mjModel_* model, mjData_* data, const robot::GripperDescription& gripper, double opening,
          const GripperSettings& settings);

  // Takes over the settings that show at once.
  void change(const GripperSettings& settings) { settings_ = settings; }

  // Takes the gripper's part of a command.
  void command(const ArmCommand& command);
  // The opening's ramp stops where it is; the grip keeps its force.
  void freeze() { target_ = ramp_; }

  // Sets the motor's force, between MuJoCo's two halves of a step of `dt` (s).
  void drive(mjData_* data, double dt);

  double opening() const { return ramp_; }  // m, as its controller knows it
  bool moving() const { return ramp_ != target_; }

  double true_opening(const mjData_* data) const;  // m, between the fingers
  // The grip point; `data` with poses up to date.
  Eigen::Vector3d p_SG(const mjData_* data) const;

 private:
  robot::GripperDescription gripper_;
  GripperSettings settings_;
  std::array<JointAddress, 2> fingers_;
  int grip_site_;
  double target_;  // m
  double ramp_;    // m
  double force_;   // N, at most
};

}  // namespace markservo::simulator
