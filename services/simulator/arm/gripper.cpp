#include "services/simulator/arm/gripper.hpp"

#include <algorithm>
#include <cstddef>

#include "services/simulator/arm/gripper_mjcf.hpp"
#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {
namespace {

constexpr double kFingerStiffness = 20000.0;  // N/m

}  // namespace

Gripper::Gripper(const mjModel_* model, mjData_* data, const robot::GripperDescription& gripper, double opening,
                 const GripperSettings& settings)
    : gripper_(gripper),
      settings_(settings),
      grip_site_(mj_name2id(model, mjOBJ_SITE, kGripSite)),
      target_(opening),
      ramp_(opening),
      force_(gripper.force_max) {
  for (std::size_t i = 0; i < fingers_.size(); ++i) {
    fingers_[i] = joint_address(model, kFingers[i]);
    data->qpos[fingers_[i].qpos] = 0.5 * opening;
  }
}

void Gripper::command(const ArmCommand& command) {
  target_ = std::clamp(command.gripper_opening, 0.0, gripper_.opening_max);
  force_ = std::clamp(command.gripper_force, 0.0, gripper_.force_max);
}

void Gripper::drive(mjData_* data, double dt) {
  const double step = settings_.speed * dt;
  const double change = std::clamp(target_ - ramp_, -step, step);
  ramp_ += change;
  const double speed = change / dt;
  for (const JointAddress& finger : fingers_) {
    const double force = kFingerStiffness * (0.5 * ramp_ - data->qpos[finger.qpos]) + kFingerDamping * 0.5 * speed;
    data->qfrc_applied[finger.dof] = std::clamp(force, -force_, force_) + data->qfrc_bias[finger.dof];
  }
}

double Gripper::true_opening(const mjData_* data) const {
  double opening = 0.0;
  for (const JointAddress& finger : fingers_) opening += data->qpos[finger.qpos];
  return opening;
}

Eigen::Vector3d Gripper::p_SG(const mjData_* data) const {
  return vector(data->site_xpos + kVector * grip_site_);
}

}  // namespace markservo::simulator
