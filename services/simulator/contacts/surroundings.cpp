#include "services/simulator/contacts/surroundings.hpp"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstddef>

#include "services/simulator/contacts/contact_classes.hpp"

namespace markservo::simulator {
namespace {

// Numbers a vector and a rotation matrix take in MuJoCo's arrays.
constexpr std::ptrdiff_t kVector = 3;
constexpr std::ptrdiff_t kMatrix = 9;

// Which of a box's axes stands upright; -1: none. `axes` row by row.
int upright_axis(const mjtNum* axes) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axes[6 + k]) > 1.0 - 1e-9) return k;
  }
  return -1;
}

}  // namespace

std::vector<std::optional<double>> cast_rays(const mjModel_* model, const mjData_* data, const std::vector<Ray>& rays) {
  mjtByte groups[mjNGROUP];
  for (int group = 0; group < mjNGROUP; ++group) groups[group] = group == kRobotGroup ? 0 : 1;
  constexpr mjtByte kWithStaticGeoms = 1;
  constexpr int kNoBody = -1;
  std::vector<std::optional<double>> distances;
  distances.reserve(rays.size());
  for (const Ray& ray : rays) {
    int geom = -1;
    const double way =
        mj_ray(model, data, ray.origin.data(), ray.direction.data(), groups, kWithStaticGeoms, kNoBody, &geom);
    distances.push_back(way >= 0.0 ? std::optional<double>(way) : std::nullopt);
  }
  return distances;
}

std::vector<int> standing_boxes(const mjModel_* model, const mjData_* data, double z_from, double z_to) {
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

Footprint footprint_of(const mjModel_* model, const mjData_* data, int geom) {
  const mjtNum* axes = data->geom_xmat + kMatrix * geom;
  const mjtNum* half = model->geom_size + kVector * geom;
  const mjtNum* centre = data->geom_xpos + kVector * geom;
  const int upright = upright_axis(axes);
  const int first = (upright + 1) % 3;
  const int second = (upright + 2) % 3;
  return {{centre[0], centre[1]}, {half[first], half[second]}, std::atan2(axes[3 + first], axes[first])};
}

}  // namespace markservo::simulator
