#pragma once

// Scores the paper's method, and ours at the same moments, per axis as the paper does.

#include <Eigen/Core>
#include <vector>

#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

// The paper's values at one read that found a tag, and ours.
struct PaperRead {
  double time = 0.0;                                      // s, when the values are meant to hold
  Eigen::Vector2d measured = Eigen::Vector2d::Zero();     // m in W, the weighted average: x_m, y_m
  Eigen::Vector2d compensated = Eigen::Vector2d::Zero();  // m in W: x_com, y_com
  Eigen::Vector2d fused = Eigen::Vector2d::Zero();        // m in W, our antenna's place
};

// What a read got wrong. Signed, in W.
struct PaperError {
  int read = 0;  // its number in the run, from 1
  double time = 0.0;
  Eigen::Vector2d measured = Eigen::Vector2d::Zero();     // m
  Eigen::Vector2d compensated = Eigen::Vector2d::Zero();  // m
  Eigen::Vector2d fused = Eigen::Vector2d::Zero();        // m
  Eigen::Vector2d along = Eigen::Vector2d::Zero();        // unit vector of the true motion
};

// The errors of the reads from `from` to `to` (s) against the antenna's true place, p_RF (m) from the robot's. Reads
// outside still count in the numbering.
std::vector<PaperError> score_paper(const std::vector<PaperRead>& reads, const TruePath& path,
                                    const Eigen::Vector2d& p_RF, double from, double to);

struct Spread {
  double mean = 0.0;
  double max = 0.0;
  double min = 0.0;
  int n = 0;
};

// Of the absolute values; NaN where there are none.
Spread absolute_spread(const std::vector<double>& values);

}  // namespace markservo::experiments
