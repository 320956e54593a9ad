#pragma once

// Something that stands in the robot's way, as the settings put it there.

#include <string>

#include "services/simulator/scene/obstacle_settings.hpp"
#include "services/simulator/scene/scene_frame.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

// As MuJoCo's MJCF: a mocap body, so that it is wherever it is put and nothing moves it. Needs the material matt.
std::string obstacle_body();

class Obstacle {
 public:
  // `floor_z`: m in S.
  Obstacle(const mjModel_* model, const SceneFrame& frame, double floor_z);

  // Stands there from now on, or nowhere.
  void put(mjModel_* model, mjData_* data, const ObstacleSettings& settings) const;

 private:
  SceneFrame frame_;
  double floor_z_;
  int body_;
};

}  // namespace markservo::simulator
