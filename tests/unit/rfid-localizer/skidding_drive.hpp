#pragma once

// RFID_TAG_HITS and WHEEL_ODOMETRY of a drive around the hall's middle, by wheels that are far worse than robot.yaml
// states, as messages. Needs no simulator.

#include <cmath>
#include <cstdint>
#include <markservo/RfidTagHits.hpp>
#include <markservo/WheelOdometry.hpp>
#include <random>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "tests/unit/rfid-localizer/ideal_drive.hpp"
#include "tests/unit/rfid-localizer/tag_round.hpp"

namespace markservo::rfid_localizer::test {

class SkiddingDrive {
 public:
  explicit SkiddingDrive(const robot::RobotDescription& robot) : robot_(robot) {}

  // Number `number` of 50 a second, from 1 on; to be asked for in order.
  WheelOdometry odometry(std::int64_t number) {
    const double way = kSpeed * kPeriod;
    const double skid = kDrift * std::sqrt(way) * normal_(bits_);
    const double half_turn = 0.5 * robot_.base->track * (way / kRadius + skid);
    left_ += way - half_turn;
    right_ += way + half_turn;
    WheelOdometry message{};
    message.utime = IdealDrive::kEpoch + number * 20'000;
    message.left_distance = left_;
    message.right_distance = right_;
    message.left_ticks = static_cast<std::int32_t>(std::lround(left_ / robot_.base->metres_per_tick()));
    message.right_ticks = static_cast<std::int32_t>(std::lround(right_ / robot_.base->metres_per_tick()));
    return message;
  }

  // The round that arrives with that odometry; its middle is the reader's delay before.
  RfidTagHits hits(std::int64_t number) const {
    const double angle = kSpeed / kRadius * (kPeriod * static_cast<double>(number) - robot_.rfid->delay);
    const Eigen::Vector2d p_WR =
        Eigen::Vector2d(2.0, 2.0) + kRadius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return tag_round(robot_, "hall", p_WR, IdealDrive::kEpoch + number * 20'000);
  }

 private:
  static constexpr double kPeriod = 0.02;                    // s
  static constexpr double kSpeed = 0.4;                      // m/s
  static constexpr double kRadius = 1.2;                     // m
  static constexpr double kDrift = geometry::radians(12.0);  // rad per sqrt(m)

  robot::RobotDescription robot_;
  std::mt19937_64 bits_{1};
  std::normal_distribution<double> normal_;
  double left_ = 0.0;   // m
  double right_ = 0.0;  // m
};

}  // namespace markservo::rfid_localizer::test
