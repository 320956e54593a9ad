#include "services/simulator/arm/arm.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstddef>

#include "common/geometry/degrees.hpp"
#include "services/simulator/arm/arm_mjcf.hpp"

namespace markservo::simulator {
namespace {

// The drive that makes the arm follow its servos' shafts: with the joints' armature of 0.15 kg m2 and damping of
// 60 N m s critically damped at 200 rad/s; a book at arm's length bends it by 0.01 degrees.
constexpr double kJointStiffness = 6000.0;  // N m/rad
constexpr double kJointTorqueMax = 200.0;   // N m, keeps a collision finite

}  // namespace

Arm::Arm(const mjModel_* model, mjData_* data, const robot::ArmDescription& arm, const ArmSettings& start,
         const ServoSettings& servos)
    : arm_(arm), settings_(servos) {
  const double start_deg[] = {start.start_yaw_deg, start.start_shoulder_deg, start.start_elbow_deg};
  for (std::size_t i = 0; i < robot::kNumJoints; ++i) {
    const double angle = start_deg[i] * geometry::kRadiansPerDegree;
    joints_.push_back({joint_address(model, kArmJoints[i]), ServoModel(angle)});
    data->qpos[joints_.back().address.qpos] = angle;
  }
}

void Arm::command(const ArmCommand& command) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    joints_[i].servo.command(std::clamp(command.position[row], arm_.joints[i].min, arm_.joints[i].max),
                             command.speed_limit[row]);
  }
}

void Arm::freeze() {
  for (Joint& joint : joints_) joint.servo.freeze();
}

ServoParameters Arm::parameters(std::size_t joint) const {
  ServoParameters parameters;
  parameters.speed =
      settings_.speed_deg_s > 0.0 ? settings_.speed_deg_s * geometry::kRadiansPerDegree : arm_.joints[joint].speed;
  parameters.acceleration = settings_.acceleration_deg_s2 * geometry::kRadiansPerDegree;
  parameters.deadband = settings_.deadband_deg * geometry::kRadiansPerDegree;
  parameters.deadband_kind = settings_.deadband_kind == 0.0 ? DeadbandKind::kStopsAtEdge : DeadbandKind::kRunsHome;
  parameters.backlash = settings_.backlash_deg * geometry::kRadiansPerDegree;
  return parameters;
}

void Arm::drive(mjData_* data, double dt) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    // The joint is where the step begins: against the shaft at its end it would run ahead by a step.
    const double behind = joint.servo.shaft() - data->qpos[joint.address.qpos];
    joint.servo.step(parameters(i), dt);
    const double torque = kJointStiffness * behind + kJointDamping * joint.servo.shaft_speed();
    // qfrc_bias carries weight and gyroscopic forces: the drive holds the arm's own weight without bending.
    data->qfrc_applied[joint.address.dof] =
        std::clamp(torque, -kJointTorqueMax, kJointTorqueMax) + data->qfrc_bias[joint.address.dof];
  }
}

ArmReading Arm::reading() const {
  ArmReading reading;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    reading.position[row] = joints_[i].servo.ramp();
    reading.speed[row] = joints_[i].servo.ramp_speed();
    reading.moving = reading.moving || joints_[i].servo.moving();
  }
  return reading;
}

robot::JointVector Arm::shafts(const mjData_* data) const {
  robot::JointVector shafts;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    shafts[static_cast<Eigen::Index>(i)] = data->qpos[joints_[i].address.qpos];
  }
  return shafts;
}

}  // namespace markservo::simulator
