#pragma once

// Courses of the simulated base.

#include <cstdint>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/experiments/localisation/cases.hpp"
#include "tests/experiments/localisation/recorded_drive.hpp"

namespace markservo::experiments {

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

// Drives the plan.
Drive drive(const robot::RobotDescription& robot, const simulator::BaseRigParameters& rig, const CoursePlan& plan,
            std::uint64_t seed);

}  // namespace markservo::experiments
