#pragma once

// Settings `base.*`: where the robot starts, and how its true way differs from what its encoders tell.

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct BaseModelParameters;
struct DockScene;

struct BaseSettings {
  double start_x = 0.0;
  double start_y = 0.0;
  double start_heading_deg = 0.0;
  double scale_sigma = 0.0;
  double drift_deg_per_sqrt_m = 0.0;
  double slip = 0.0;
  double pivot_wander = 0.0;

  geometry::PlanePose start() const {  // X_WR
    return geometry::pose_from_degrees(start_x, start_y, start_heading_deg);
  }
};

inline constexpr Setting<BaseSettings> kBaseSettings[] = {
    {"base.start_x", &BaseSettings::start_x, -100.0, 100.0, TakesEffect::kAtReset,
     "m, where the robot starts, in W; default: docked"},
    {"base.start_y", &BaseSettings::start_y, -100.0, 100.0, TakesEffect::kAtReset, "m, where the robot starts, in W"},
    {"base.start_heading_deg", &BaseSettings::start_heading_deg, -360.0, 360.0, TakesEffect::kAtReset,
     "deg, its heading, counter-clockwise from W's x axis"},
    {"base.scale_sigma", &BaseSettings::scale_sigma, 0.0, 0.2, TakesEffect::kAtReset,
     "standard deviation of the factor between the true way and what the encoders tell"},
    {"base.drift_deg_per_sqrt_m", &BaseSettings::drift_deg_per_sqrt_m, 0.0, 50.0, TakesEffect::kAtReset,
     "deg per sqrt(m), random walk of the heading against what the encoders tell"},
    {"base.slip", &BaseSettings::slip, 0.0, 0.5, TakesEffect::kAtReset,
     "mean share of a wheel's turning that makes no way"},
    {"base.pivot_wander", &BaseSettings::pivot_wander, 0.0, 0.5, TakesEffect::kAtReset,
     "m per sqrt(rad), random walk of the place while the base turns"},
};

// At `dock`, the encoders as good as robot.yaml has them.
BaseSettings default_base_settings(const robot::RobotDescription& robot, const DockScene& dock);

BaseModelParameters base_model_parameters(const BaseSettings& settings);

}  // namespace markservo::simulator
