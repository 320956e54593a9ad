#pragma once

// RFID_TAG_HITS and WHEEL_ODOMETRY of a drive without noise along the course of config/robot.yaml, as messages: all
// tags within the reading radius answer, and the wheels tell the truth. Needs no simulator.

#include <cmath>
#include <cstdint>
#include <markservo/RfidTagHits.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/robot/robot_description.hpp"
#include "tests/unit/rfid-localizer/tag_round.hpp"

namespace markservo::rfid_localizer::test {

class IdealDrive {
 public:
  static constexpr std::int64_t kEpoch = 1'700'000'000'000'000;  // us
  static constexpr std::int64_t kSession = 4;                    // of both writers

  explicit IdealDrive(const robot::RobotDescription& robot) : robot_(robot) {}

  // The robot stands for 2 s, then goes along y at 0.4 m/s.
  double x() const { return 0.2; }                                                // m
  double y(double time) const { return 0.05 + 0.4 * std::max(time - 2.0, 0.0); }  // m, at `time` (s)

  // Number `number` of 50 a second, from 1 on.
  WheelOdometry odometry(std::int64_t number) const {
    const double time = 0.02 * static_cast<double>(number);
    WheelOdometry message{};
    message.utime = kEpoch + number * 20'000;
    message.session = kSession;
    message.seq = number;
    message.left_distance = message.right_distance = y(time) - y(0.0);
    message.left_ticks = message.right_ticks =
        static_cast<std::int32_t>(std::lround(message.left_distance / robot_.base->metres_per_tick()));
    return message;
  }

  // Number `number` of 10 a second, from 1 on; its middle is the reader's delay before `utime`.
  RfidTagHits hits(std::int64_t number) const {
    const std::int64_t utime = kEpoch + 200'000 + number * 100'000;
    const double time = 1e-6 * static_cast<double>(utime - kEpoch) - robot_.rfid->delay;
    RfidTagHits message = tag_round(robot_, "", {x(), y(time)}, utime);
    message.session = kSession;
    message.seq = number;
    return message;
  }

 private:
  robot::RobotDescription robot_;
};

}  // namespace markservo::rfid_localizer::test
