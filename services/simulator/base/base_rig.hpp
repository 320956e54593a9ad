#pragma once

// The simulated base with its encoders, tag floor and reader on one schedule: the same for the simulator and for
// experiments that need no pictures. Time is counted in steps from a given epoch.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_model.hpp"
#include "services/simulator/readers/rfid_reader_model.hpp"
#include "services/simulator/readers/tag_floor.hpp"

namespace markservo::simulator {

struct BaseRigParameters {
  BaseModelParameters base;
  TagFloorParameters floor;
  RfidReaderParameters reader;
  std::string tag_field;  // name in robot.yaml; empty: the one in use
};

// What the encoders' driver tells; as WheelOdometry.lcm has it.
struct OdometryReading {
  std::int64_t utime = 0;  // us
  WheelTicks ticks;
  double left_distance = 0.0;   // m
  double right_distance = 0.0;  // m
};

struct BaseTruth {
  geometry::PlanePose pose;   // X_WR
  double speed = 0.0;         // m/s
  double turn_rate = 0.0;     // rad/s
  double wheel_travel = 0.0;  // m, of a wheel on average, both directions added up
  double turned = 0.0;        // rad, as the wheels tell it, both directions added up
};

// What has become due since it was last taken.
struct BaseOutputs {
  std::vector<TagRound> rounds;  // oldest first
  std::optional<OdometryReading> odometry;
};

class BaseRig {
 public:
  static constexpr std::int64_t kStep_us = 2'000;
  static constexpr std::int64_t kOdometryPeriod_us = 20'000;
  static constexpr std::int64_t kCommandTimeout_us = 300'000;

  // At rest at X_WR = `start`, at `epoch` (us, above 0): the first odometry and the first round are due then. A robot
  // without rfid or floor_tags reads none. Throws ConfigurationError if it has no base or the tag field is unknown,
  // std::invalid_argument for parameters out of range.
  BaseRig(const robot::RobotDescription& robot, const BaseRigParameters& parameters, const geometry::PlanePose& start,
          std::uint64_t seed, std::int64_t epoch);

  // Wanted speed (m/s) and turn rate (rad/s), good for 0.3 s: then the base brakes unless told again. Throws
  // std::invalid_argument unless finite.
  void command(double speed, double turn_rate);

  // Brakes until the next command.
  void freeze();

  // From now on the reader reads like this. Throws as its constructor, and changes nothing.
  void change_reader(const RfidReaderParameters& parameters);

  // Lets kStep_us pass.
  void step();

  BaseOutputs take_due();

  std::int64_t utime() const { return utime_; }  // us
  BaseTruth truth() const {
    return {base_.pose(), base_.speed(), base_.turn_rate(), base_.wheel_travel(), base_.turned()};
  }
  // The true floor; null without a reader.
  const TagFloor* floor() const { return reader_ ? &reader_->floor() : nullptr; }

 private:
  std::int64_t epoch_;
  std::int64_t utime_;
  BaseModel base_;
  std::optional<RfidReaderModel> reader_;
  std::optional<std::int64_t> commanded_utime_;
  BaseOutputs due_;
};

}  // namespace markservo::simulator
