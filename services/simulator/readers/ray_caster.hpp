#pragma once

// How far the sonars' rays go in the MuJoCo model.

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "services/simulator/readers/ray.hpp"
#include "services/simulator/scene/scene_frame.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class RayCaster {
 public:
  // `floor_z`: m in S.
  RayCaster(const SceneFrame& frame, double floor_z) : frame_(frame), floor_z_(floor_z) {}

  // m, how far each ray from the robot, in R, goes until it meets something that is not the robot; nothing if it never
  // does. Brings the poses of `data` up to date.
  std::vector<std::optional<double>> cast(const mjModel_* model, mjData_* data, const Eigen::Isometry3d& X_SC,
                                          const std::vector<Ray>& rays_R) const;

 private:
  SceneFrame frame_;
  double floor_z_;
};

}  // namespace markservo::simulator
