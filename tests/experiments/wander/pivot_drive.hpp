#pragma once

// A drive to and fro over a field of tags, with a pivot of 90 degrees at the end of each leg.

#include <cstdint>

#include "common/robot/robot_description.hpp"
#include "services/simulator/base/base_rig.hpp"
#include "tests/experiments/localisation/recorded_drive.hpp"

namespace markservo::experiments {

struct PivotDrive {
  int pivots = 60;
  double leg_time = 15.0;                       // s, from one leg's begin to the next: 15 minutes in all
  double speed = 0.3;                           // m/s: a leg across the field and a pivot take less than that
  double pivot_rate = geometry::radians(90.0);  // rad/s
  double margin = 0.3;                          // m, from the field's edge
  double turning_band = 0.8;                    // m, within which the legs end on either side
};

// Legs along W's axes from one side of the field to the other.
Drive drive_with_pivots(const robot::RobotDescription& robot, const simulator::BaseRigParameters& rig,
                        const PivotDrive& course, std::uint64_t seed);

}  // namespace markservo::experiments
