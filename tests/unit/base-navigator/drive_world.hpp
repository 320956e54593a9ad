#pragma once

// A flat world for the navigator: walls, a differential drive with limits and delay, sonars, a localiser with noise.

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/base-navigator/navigator_types.hpp"
#include "services/base-navigator/obstacles/free_path.hpp"

namespace markservo::base_navigator::test {

struct Wall {
  Eigen::Vector2d a;
  Eigen::Vector2d b;
};

// The four walls of a box.
std::vector<Wall> box(double x_min, double y_min, double x_max, double y_max);

struct WorldSettings {
  double position_noise = 0.01;  // m, standard deviation of each axis while driving
  double heading_noise = 0.026;  // rad (1.5 degrees)
  double odometry_scale = 1.01;  // true way over told way
  double sonar_noise = 0.01;     // m
  double lost_echoes = 0.03;     // share
  int command_delay = 1;         // steps of 20 ms
  double base_braking = 1.0;     // share of robot.yaml's acceleration that the base really has
};

inline constexpr std::int64_t kStep_us = 20'000;
inline constexpr int kStepsPerScan = 5;
inline constexpr int kStepsPerRead = 5;

class DriveWorld {
 public:
  DriveWorld(const robot::RobotDescription& robot, const WorldSettings& settings, std::uint64_t seed);

  // Lets 20 ms pass.
  void step(const Command& command);

  OdometrySample odometry() const;
  PoseSample pose();
  SonarScanSample scan();
  bool scan_due() const { return steps_ % kStepsPerScan == 0; }

  // m, from the true outline to the nearest wall.
  double nearest() const;

  std::vector<Wall> walls;
  geometry::PlanePose X_WR;  // the truth
  double speed = 0.0;
  double turn_rate = 0.0;
  std::int64_t utime = 1'700'000'000'000'000;
  double position_sigma = 0.012;  // as the localiser tells it
  double heading_sigma = 0.03;
  Localisation localisation = Localisation::kLocalised;

 private:
  double shrunk() const;
  double ray(const geometry::PlanePose& X_WS, double angle) const;

  robot::RobotDescription robot_;
  WorldSettings settings_;
  std::mt19937_64 random_;
  std::deque<Command> commands_;
  geometry::PlanePose pose_error_;  // in R
  double left_ = 0.0;
  double right_ = 0.0;
  double stood_ = 0.0;  // s
  int steps_ = 0;
};

}  // namespace markservo::base_navigator::test
