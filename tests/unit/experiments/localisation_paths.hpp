#pragma once

// Paths and floors that the tests of the localisation's scoring share.

#include <cmath>
#include <vector>

#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

inline TruePath standing(const Eigen::Vector2d& p_WR, double heading = 0.0) {
  PathPoint begin;
  begin.p_WR = p_WR;
  begin.heading = heading;
  PathPoint end = begin;
  end.time = 100.0;
  return TruePath({begin, end});
}

// From `begin` straight on at `heading`; `duration` s at `speed` m/s.
inline TruePath straight(const Eigen::Vector2d& begin, double heading, double speed, double duration) {
  PathPoint from;
  from.p_WR = begin;
  from.heading = heading;
  from.speed = speed;
  PathPoint to = from;
  to.time = duration;
  to.p_WR += speed * duration * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  return TruePath({from, to});
}

// A square lattice around the origin, from -half to +half along both axes.
inline std::vector<Eigen::Vector2d> lattice(double spacing, double half) {
  const int count = static_cast<int>(std::floor(half / spacing));
  std::vector<Eigen::Vector2d> tags;
  for (int row = -count; row <= count; ++row) {
    for (int column = -count; column <= count; ++column) tags.emplace_back(column * spacing, row * spacing);
  }
  return tags;
}

}  // namespace markservo::experiments
