#include "services/simulator/readers/ray_caster.hpp"

#include <mujoco/mujoco.h>

#include "services/simulator/contacts/contact_classes.hpp"

namespace markservo::simulator {
namespace {

// m, how far a ray in S goes; nothing if it never meets anything.
std::optional<double> way_of(const mjModel* model, const mjData* data, const Ray& ray) {
  mjtByte groups[mjNGROUP];
  for (int group = 0; group < mjNGROUP; ++group) groups[group] = group == kRobotGroup ? 0 : 1;
  constexpr mjtByte kWithStaticGeoms = 1;
  constexpr int kNoBody = -1;
  int geom = -1;
  const double way =
      mj_ray(model, data, ray.origin.data(), ray.direction.data(), groups, kWithStaticGeoms, kNoBody, &geom);
  return way >= 0.0 ? std::optional<double>(way) : std::nullopt;
}

}  // namespace

std::vector<std::optional<double>> RayCaster::cast(const mjModel_* model, mjData_* data, const Eigen::Isometry3d& X_SC,
                                                   const std::vector<Ray>& rays_R) const {
  mj_kinematics(model, data);
  std::vector<std::optional<double>> ways;
  ways.reserve(rays_R.size());
  for (const Ray& ray : rays_R) {
    const Eigen::Vector2d p_C = frame_.in_camera(ray.origin.head<2>());
    const Eigen::Vector3d direction_C(-ray.direction.y(), ray.direction.x(), ray.direction.z());
    const Ray ray_S{X_SC * Eigen::Vector3d(p_C.x(), p_C.y(), floor_z_ + ray.origin.z()), X_SC.linear() * direction_C};
    ways.push_back(way_of(model, data, ray_S));
  }
  return ways;
}

}  // namespace markservo::simulator
