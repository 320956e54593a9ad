#pragma once

// The robot's base in the MuJoCo model: it goes where it is told and no force moves it, but its speed is real, so that
// what the arm holds is carried along.

#include <Eigen/Geometry>
#include <array>

#include "common/geometry/plane_pose.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class BaseBody {
 public:
  explicit BaseBody(const mjModel_* model);

  // Puts it to `X_SC`, standing still.
  void put(mjData_* data, const geometry::PlanePose& X_SC);

  // Where the next step shall end.
  void aim(const geometry::PlanePose& X_SC) { next_ = X_SC; }

  // Before a step of `dt` (s): gives it the speed that takes it to its aim.
  void depart(mjData_* data, double dt) const;
  // After it: it is there, without the rounding and the arm's push.
  void arrive(mjData_* data);

  Eigen::Isometry3d X_SC() const;

 private:
  struct Joint {
    int qpos;  // address in qpos
    int dof;   // address in qvel
  };
  std::array<Joint, 3> joints_{};  // x, y, turn
  geometry::PlanePose now_;
  geometry::PlanePose next_;
};

}  // namespace markservo::simulator
