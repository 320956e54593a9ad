#include "services/simulator/contacts/arm_touch.hpp"

#include <mujoco/mujoco.h>

#include <cstddef>

#include "services/simulator/arm/arm_mjcf.hpp"
#include "services/simulator/base/base_mjcf.hpp"

namespace markservo::simulator {

ArmTouch::ArmTouch(const mjModel_* model)
    : robot_base_(mj_name2id(model, mjOBJ_BODY, kRobotBase)), is_arm_(static_cast<std::size_t>(model->nbody), false) {
  const int column = mj_name2id(model, mjOBJ_BODY, kArmColumn);
  for (int body = column; body < model->nbody; ++body) {
    const int parent = model->body_parentid[body];
    is_arm_[static_cast<std::size_t>(body)] = body == column || is_arm_[static_cast<std::size_t>(parent)];
  }
}

void ArmTouch::observe(const mjModel_* model, const mjData_* data) {
  if (happened_) return;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    const auto body1 = static_cast<std::size_t>(model->geom_bodyid[contact.geom1]);
    const auto body2 = static_cast<std::size_t>(model->geom_bodyid[contact.geom2]);
    if (is_arm_[body1] == is_arm_[body2]) continue;
    happened_ = true;
    const int arm_geom = is_arm_[body1] ? contact.geom1 : contact.geom2;
    const int other_geom = is_arm_[body1] ? contact.geom2 : contact.geom1;
    pair_ = std::string(name_of(model, arm_geom)) + " - " + name_of(model, other_geom);
    return;
  }
}

void ArmTouch::forget() {
  happened_ = false;
  pair_.clear();
}

const char* ArmTouch::name_of(const mjModel_* model, int geom) const {
  const int body = model->geom_bodyid[geom];
  const bool of_many_parts = body == 0 || body == robot_base_;
  const char* name = of_many_parts ? mj_id2name(model, mjOBJ_GEOM, geom) : mj_id2name(model, mjOBJ_BODY, body);
  return name == nullptr ? "unnamed" : name;
}

}  // namespace markservo::simulator
