#include "services/simulator/model/joint_address.hpp"

#include <mujoco/mujoco.h>

namespace markservo::simulator {

JointAddress joint_address(const mjModel_* model, const char* name) {
  const int joint = mj_name2id(model, mjOBJ_JOINT, name);
  return {model->jnt_qposadr[joint], model->jnt_dofadr[joint]};
}

}  // namespace markservo::simulator
