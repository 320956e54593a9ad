#pragma once

// A drive of the simulated base, and all that was told and true meanwhile.

#include <cstdint>
#include <functional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_rig.hpp"
#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

inline constexpr std::int64_t kEpoch_us = 1'000'000'000;  // begin of every drive

// s since the drive's begin
inline double seconds(std::int64_t utime) {
  return static_cast<double>(utime - kEpoch_us) * 1e-6;
}

struct Drive {
  std::vector<simulator::TagRound> rounds;           // as they arrived
  std::vector<simulator::OdometryReading> odometry;  // 50 Hz
  std::vector<PathPoint> truth;                      // at each odometry, by seconds()
};

// The speed (m/s) and turn rate (rad/s) to command where the base truly is so, `time` s after the drive's begin; asked
// every kControlPeriod.
using Steering = std::function<Eigen::Vector2d(const simulator::BaseTruth& truth, double time)>;
inline constexpr double kControlPeriod = static_cast<double>(simulator::BaseRig::kOdometryPeriod_us) * 1e-6;  // s

// Drives from `start` (X_WR, at rest) for `duration` s. The commands come from the true pose, so that a course is
// really followed whatever the encoders say: what is asked is the localizer's error on a known course, not a
// controller's.
Drive record_drive(const robot::RobotDescription& robot, const simulator::BaseRigParameters& rig,
                   const geometry::PlanePose& start, double duration, const Steering& steer, std::uint64_t seed);

}  // namespace markservo::experiments
