#pragma once

struct mjModel_;

namespace markservo::simulator {

// Where a joint with one degree of freedom stands in the model's state.
struct JointAddress {
  int qpos = 0;
  int dof = 0;  // in qvel and the forces
};

// The address of the joint `name`, which `model` must have.
JointAddress joint_address(const mjModel_* model, const char* name);

}  // namespace markservo::simulator
