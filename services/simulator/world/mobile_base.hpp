#pragma once

// The simulated base in its world: the rig that drives, the sonars that listen, and what it runs into.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_rig.hpp"
#include "services/simulator/base/base_settings.hpp"
#include "services/simulator/readers/reader_settings.hpp"
#include "services/simulator/readers/sonar_model.hpp"
#include "services/simulator/world/world.hpp"

namespace markservo::simulator {

// What is true at an odometry.
struct MobileBaseTruth {
  BaseTruth base;
  bool touched = false;  // ran into something since the reset
  double nearest = 0.0;  // m, from the outline to the nearest thing that stands on the floor
};

// What has become due since it was last taken.
struct MobileBaseOutputs {
  std::vector<TagRound> rounds;  // oldest first
  std::optional<SonarReading> scan;
  std::optional<OdometryReading> odometry;
};

class MobileBase {
 public:
  static constexpr std::int64_t kScanPeriod_us = 50'000;

  // At rest where `base` starts it, at `epoch` (us, above 0): the first odometry and the first scan are due then.
  // `tag_field` as BaseRigParameters'. Throws ConfigurationError if the robot has no base.
  MobileBase(const robot::RobotDescription& robot, const std::string& tag_field, const BaseSettings& base,
             const ReaderSettings& readers, std::uint64_t seed, std::int64_t epoch);

  // Takes over the settings that show at once.
  void change(const ReaderSettings& readers);

  // Both as BaseRig has them.
  void command(double speed, double turn_rate) { rig_.command(speed, turn_rate); }
  void freeze() { rig_.freeze(); }

  // Lets a step pass in the base and in `world`, which it stands in. Throws as World::step.
  void step(World& world);

  MobileBaseOutputs take_due(World& world);
  MobileBaseTruth truth(const World& world) const;

 private:
  BaseRig rig_;
  std::optional<SonarModel> sonars_;
  SonarParameters sonar_parameters_;
  std::int64_t next_scan_;
  bool touched_ = false;
};

}  // namespace markservo::simulator
