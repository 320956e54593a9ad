#pragma once

// The arm's joints in the MuJoCo model, each driven by its servo.

#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm_command.hpp"
#include "services/simulator/arm/arm_settings.hpp"
#include "services/simulator/arm/servo_model.hpp"
#include "services/simulator/arm/servo_settings.hpp"
#include "services/simulator/model/joint_address.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class Arm {
 public:
  // Puts the joints of `data` to the start posture.
  Arm(const mjModel_* model, mjData_* data, const robot::ArmDescription& arm, const ArmSettings& start,
      const ServoSettings& servos);

  void change(const ServoSettings& servos) { settings_ = servos; }

  // Takes the joints' part of a command.
  void command(const ArmCommand& command);
  // The ramps stop where they are.
  void freeze();

  // Sets the servos' torques, between MuJoCo's two halves of a step of `dt` (s).
  void drive(mjData_* data, double dt);

  // What the servos' controller knows, without the gripper.
  ArmReading reading() const;
  // rad, where the joints really are.
  robot::JointVector shafts(const mjData_* data) const;

 private:
  struct Joint {
    JointAddress address;
    ServoModel servo;
  };

  ServoParameters parameters(std::size_t joint) const;

  robot::ArmDescription arm_;
  ServoSettings settings_;
  std::vector<Joint> joints_;
};

}  // namespace markservo::simulator
