#include "services/simulator/base/base_body.hpp"

#include <mujoco/mujoco.h>

#include "services/simulator/base/base_mjcf.hpp"

namespace markservo::simulator {
namespace {

std::array<double, 3> values(const geometry::PlanePose& pose) {
  return {pose.x, pose.y, pose.heading};
}

}  // namespace

BaseBody::BaseBody(const mjModel_* model, mjData_* data, const SceneFrame& frame, const geometry::PlanePose& X_WR)
    : frame_(frame) {
  for (std::size_t i = 0; i < joints_.size(); ++i) joints_[i] = joint_address(model, kBaseJoints[i]);
  aim(X_WR);
  arrive(data);
  for (const JointAddress& joint : joints_) data->qvel[joint.dof] = 0.0;
}

void BaseBody::aim(const geometry::PlanePose& X_WR) {
  X_WR_ = X_WR;
  next_ = frame_.camera(X_WR);
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
