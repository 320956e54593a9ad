#pragma once

// True motion between two of the simulator's stamps.

#include <vector>

#include "tests/system/fault_campaign/timeline.hpp"

namespace markservo::campaign {

// From one SIM_TRUTH to the next of the same world.
struct ArmStep {
  const Heard<SimTruth>* from = nullptr;
  const Heard<SimTruth>* to = nullptr;
  double way = 0.0;    // rad, of the farthest joint
  double speed = 0.0;  // rad/s, by the world's clock
};

// Over about kBaseStep_s: single steps of the odometry are too short to tell a speed by.
struct BaseStep {
  const Heard<SimBaseTruth>* from = nullptr;
  const Heard<SimBaseTruth>* to = nullptr;
  double way = 0.0;    // m
  double speed = 0.0;  // m/s
};

inline constexpr double kBaseStep_s = 0.1;

// The largest difference of two joints, rad; 0 where they are not the same ones.
double farthest_joint(const std::vector<double>& a, const std::vector<double>& b);
// m, between the places of two poses.
double way_between(const SimBaseTruth& a, const SimBaseTruth& b);
// Whether `next` goes on with the world of `last`: same simulator, no reset between them.
bool same_world(const SimTruth& last, const SimTruth& next);

std::vector<ArmStep> arm_steps(const Timeline& timeline);
std::vector<BaseStep> base_steps(const Timeline& timeline);

}  // namespace markservo::campaign
