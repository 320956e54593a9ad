#include "services/simulator/base/base_body.hpp"

#include <mujoco/mujoco.h>

#include "services/simulator/base/base_mjcf.hpp"

namespace markservo::simulator {
namespace {

std::array<double, 3> values(const geometry::PlanePose& pose) {
  return {pose.x, pose.y, pose.heading};
}

}  // namespace

BaseBody::BaseBody(const mjModel_* model) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const int joint = mj_name2id(model, mjOBJ_JOINT, kBaseJoints[i]);
    joints_[i] = {model->jnt_qposadr[joint], model->jnt_dofadr[joint]};
  }
}

void BaseBody::put(mjData_* data, const geometry::PlanePose& X_SC) {
  next_ = X_SC;
  arrive(data);
  for (const Joint& joint : joints_) data->qvel[joint.dof] = 0.0;
}

void BaseBody::depart(mjData_* data, double dt) const {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    data->qvel[joints_[i].dof] = (values(next_)[i] - values(now_)[i]) / dt;
  }
}

void BaseBody::arrive(mjData_* data) {
  now_ = next_;
  for (std::size_t i = 0; i < joints_.size(); ++i) data->qpos[joints_[i].qpos] = values(now_)[i];
}

Eigen::Isometry3d BaseBody::X_SC() const {
  Eigen::Isometry3d X_SC = Eigen::Isometry3d::Identity();
  X_SC.translation() << now_.x, now_.y, 0.0;
  X_SC.linear() = Eigen::AngleAxisd(now_.heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X_SC;
}

}  // namespace markservo::simulator
