#include "services/simulator/contacts/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/contacts/footprint.hpp"
#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {
namespace {

// Which of a box's axes stands upright; -1: none. `axes` row by row.
int upright_axis(const mjtNum* axes) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axes[6 + k]) > 1.0 - 1e-9) return k;
  }
  return -1;
}

// The upright boxes of the room that reach into heights `z_from` to `z_to` (m in S), and mocap boxes wherever they are.
std::vector<int> standing_boxes(const mjModel* model, const mjData* data, double z_from, double z_to) {
  std::vector<int> boxes;
  for (int geom = 0; geom < model->ngeom; ++geom) {
    const int body = model->geom_bodyid[geom];
    const bool of_the_room = model->body_weldid[body] == 0 && model->geom_group[geom] != kRobotGroup;
    const bool solid = model->geom_contype[geom] != 0;
    if (!of_the_room || !solid || model->geom_type[geom] != mjGEOM_BOX) continue;
    const mjtNum* axes = data->geom_xmat + kMatrix * geom;
    const mjtNum* half = model->geom_size + kVector * geom;
    const int upright = upright_axis(axes);
    if (upright < 0) continue;
    const double half_height = half[upright];
    const double z = data->geom_xpos[kVector * geom + 2];
    const bool reaches = z - half_height < z_to && z + half_height > z_from;
    if (reaches || model->body_mocapid[body] >= 0) boxes.push_back(geom);
  }
  return boxes;
}

// The floor that an upright box stands on, in S.
Footprint footprint_of(const mjModel* model, const mjData* data, int geom) {
  const mjtNum* axes = data->geom_xmat + kMatrix * geom;
  const mjtNum* half = model->geom_size + kVector * geom;
  const mjtNum* centre = data->geom_xpos + kVector * geom;
  const int upright = upright_axis(axes);
  const int first = (upright + 1) % 3;
  const int second = (upright + 2) % 3;
  return {{centre[0], centre[1]}, {half[first], half[second]}, std::atan2(axes[3 + first], axes[first])};
}

}  // namespace

Clearance::Clearance(const robot::RobotDescription& robot, const SceneFrame& frame, double floor_z)
    : base_(robot.base), plate_z_(robot.arm ? robot.arm->p_CA.z() : 0.0), frame_(frame), floor_z_(floor_z) {}

void Clearance::survey(const mjModel_* model, const mjData_* data) {
  constexpr double kAboveFloor = 0.001;  // m: what the floor itself does not reach
  if (base_) boxes_ = standing_boxes(model, data, floor_z_ + kAboveFloor, plate_z_);
}

double Clearance::at(const mjModel_* model, const mjData_* data, const geometry::PlanePose& X_WR) const {
  double nearest = std::numeric_limits<double>::infinity();
  if (!base_) return nearest;
  const Eigen::Vector2d half(0.5 * (base_->front + base_->rear), base_->half_width);
  const Eigen::Vector2d middle = X_WR * Eigen::Vector2d(0.5 * (base_->front - base_->rear), 0.0);
  const Footprint outline{frame_.place(middle), half, frame_.forward(X_WR)};
  for (const int box : boxes_) {
    const Footprint other = footprint_of(model, data, box);
    const bool there = data->geom_xpos[kVector * box + 2] > floor_z_;
    if (there) nearest = std::min(nearest, distance(outline, other));
  }
  return nearest;
}

}  // namespace markservo::simulator
