#pragma once

// How far the base's outline is from what stands on the floor.

#include <optional>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/scene/scene_frame.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

class Clearance {
 public:
  // `floor_z`: m in S.
  Clearance(const robot::RobotDescription& robot, const SceneFrame& frame, double floor_z);

  // Finds what can stop the base: the upright boxes of the room that reach from the floor to the arm's plate, the
  // obstacle wherever it stands. `data` with poses up to date.
  void survey(const mjModel_* model, const mjData_* data);

  // m, to the nearest of these from the outline at `X_WR`; 0 if they touch. Of a robot without a base: infinity. `data`
  // with poses up to date.
  double at(const mjModel_* model, const mjData_* data, const geometry::PlanePose& X_WR) const;

 private:
  std::optional<robot::BaseDescription> base_;
  double plate_z_;  // m in S, the arm's
  SceneFrame frame_;
  double floor_z_;
  std::vector<int> boxes_;  // geoms
};

}  // namespace markservo::simulator
