#pragma once

// True motion between two of the simulator's stamps.

#include <cstdint>
#include <string>
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
  double way = 0.0;        // m
  double speed = 0.0;      // m/s
  double turn_rate = 0.0;  // rad/s, its size
};

inline constexpr double kBaseStep_s = 0.1;

// The largest difference of two joints, rad; 0 where they are not the same ones.
double farthest_joint(const std::vector<double>& a, const std::vector<double>& b);
// m, between the places of two poses.
double way_between(const SimBaseTruth& a, const SimBaseTruth& b);
// rad, between their headings, 0 to pi.
double turn_between(const SimBaseTruth& a, const SimBaseTruth& b);
// "moved 0.0031 m and 0.0200 rad" from `a` to `b`; empty where it is no more than `most_m` and `most_rad`.
std::string base_moved(const SimBaseTruth& a, const SimBaseTruth& b, double most_m, double most_rad);
// Whether `next` goes on with the world of `last`: same simulator, no reset between them.
bool same_world(const SimTruth& last, const SimTruth& next);

// Where the shafts were around a moment: at the last stamp before it, and at the next.
class ShaftsAround {
 public:
  explicit ShaftsAround(const Timeline& timeline) : truth_(timeline.truth) {}

  // How far `angle` of joint `i` is from where that joint was around `t`, rad; false where nothing is known.
  bool distance(std::int64_t t, std::size_t i, double angle, double& distance) const;

 private:
  const Stream<SimTruth>& truth_;
};

std::vector<ArmStep> arm_steps(const Timeline& timeline);
std::vector<BaseStep> base_steps(const Timeline& timeline);

}  // namespace markservo::campaign
