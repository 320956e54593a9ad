#pragma once

// The robot's base in the MuJoCo model: it goes where it is told and no force moves it, but its speed is real, so that
// what the arm holds is carried along.

#include <Eigen/Geometry>
#include <array>

#include "common/geometry/plane_pose.hpp"
#include "services/simulator/model/joint_address.hpp"
#include "services/simulator/scene/scene_frame.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class BaseBody {
 public:
  // Puts the base of `data` to `X_WR`, standing still.
  BaseBody(const mjModel_* model, mjData_* data, const SceneFrame& frame, const geometry::PlanePose& X_WR);

  // Where the next step shall end.
  void aim(const geometry::PlanePose& X_WR);

  // Before a step of `dt` (s): gives it the speed that takes it to its aim.
  void depart(mjData_* data, double dt) const;
  // After it: it is there, without the rounding and the arm's push.
  void arrive(mjData_* data);

  // Where it was last aimed at.
  const geometry::PlanePose& X_WR() const { return X_WR_; }
  // Where it is.
  Eigen::Isometry3d X_SC() const;

 private:
  SceneFrame frame_;
  std::array<JointAddress, 3> joints_{};  // x, y, turn
  geometry::PlanePose X_WR_;              // of next_
  geometry::PlanePose now_;               // X_SC
  geometry::PlanePose next_;              // X_SC
};

}  // namespace markservo::simulator
