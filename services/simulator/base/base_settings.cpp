#include "services/simulator/base/base_settings.hpp"

#include "services/simulator/base/base_model.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

BaseSettings default_base_settings(const robot::RobotDescription& robot, const DockScene& dock) {
  BaseSettings settings;
  settings.start_x = dock.x;
  settings.start_y = dock.y;
  settings.start_heading_deg = dock.heading_deg;
  if (robot.base) {
    settings.scale_sigma = robot.base->scale_sigma;
    settings.drift_deg_per_sqrt_m = geometry::degrees(robot.base->drift);
    settings.pivot_wander = robot.base->pivot_wander;
  }
  return settings;
}

BaseModelParameters base_model_parameters(const BaseSettings& settings) {
  BaseModelParameters parameters;
  parameters.scale_sigma = settings.scale_sigma;
  parameters.drift = geometry::radians(settings.drift_deg_per_sqrt_m);
  parameters.slip = settings.slip;
  parameters.pivot_wander = settings.pivot_wander;
  return parameters;
}

}  // namespace markservo::simulator
