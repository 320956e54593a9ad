#pragma once

// A drive of the simulated base along a course, and all that was told and true meanwhile.

#include <cstdint>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_rig.hpp"
#include "tests/experiments/localisation/cases.hpp"
#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

inline constexpr std::int64_t kEpoch_us = 1'000'000'000;  // begin of every drive

// s since the drive's begin
inline double seconds(std::int64_t utime) {
  return static_cast<double>(utime - kEpoch_us) * 1e-6;
}

// The speed wanted from a time on.
struct SpeedChange {
  double time = 0.0;   // s
  double speed = 0.0;  // m/s
};

struct CoursePlan {
  geometry::PlanePose start;        // X_WR, at rest
  double radius = 0.0;              // m, of a circle to the left; 0: straight on
  std::vector<SpeedChange> speeds;  // the first one at 0 s
  double duration = 0.0;            // s
  double scored_from = 0.0;         // s
  double scored_to = 0.0;           // s, at most: the antenna may leave the field before
};

// The course of a case's `seed`: its random offsets, headings and speeds.
CoursePlan plan_course(const LocalisationCase& the_case, const robot::TagField& field, std::uint64_t seed);

struct Drive {
  std::vector<simulator::TagRound> rounds;           // as they arrived
  std::vector<simulator::OdometryReading> odometry;  // 50 Hz
  std::vector<PathPoint> truth;                      // at each odometry, by seconds()
};

// Drives the plan. The commands come from the true pose, so that the course is really followed whatever the encoders
// say: what a case asks is the localizer's error on a known course, not a controller's.
Drive drive(const robot::RobotDescription& robot, const simulator::BaseRigParameters& rig, const CoursePlan& plan,
            std::uint64_t seed);

}  // namespace markservo::experiments
