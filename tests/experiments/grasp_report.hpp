#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/experiments/aim_watch.hpp"

namespace markservo::experiments {

struct GraspTrial {
  std::int64_t seed = 0;
  std::string result;  // lifted, refused, failed
  std::string reason;
  bool arm_touched = false;  // the arm touched anything, by truth
  std::string touched;       // what first
  Aim aim;
  double shaft_moved = 0.0;  // rad, refused: the farthest joint, from the reset to 1 s after the refusal
};

struct GraspCell {
  double x = 0.0;  // m, of the middle book
  double y = 0.0;  // m
  char book = 'C';
  std::string predicted;  // feasible, unreachable, out_of_view
  std::vector<GraspTrial> trials;

  // How many of the trials end as predicted: lifted where feasible; elsewhere refused for the predicted reason, with
  // nothing moved or touched.
  int as_predicted() const;
  int lifted() const;
};

// What servoing left between the grip point and its goal, over all trials in which something was gripped.
struct AimSummary {
  int trials = 0;
  double error_mean = 0.0;                               // m
  double error_p95 = 0.0;                                // m
  double error_max = 0.0;                                // m
  Eigen::Vector3d error_bias = Eigen::Vector3d::Zero();  // m, in C, the mean error vector
  double frames_mean = 0.0;                              // of servoing
  double frames_max = 0.0;
};
AimSummary summarise_aim(const std::vector<GraspCell>& cells);

// DIR/grasp.json.
void write_grasp_json(const std::vector<GraspCell>& cells, const std::string& folder);
// Our grid beside the paper's table 3, on the standard output.
void print_beside_the_paper(const std::vector<GraspCell>& cells);
// DIR/grasp.png by gnuplot; without gnuplot a line says so.
void plot_heat_map(const std::vector<GraspCell>& cells, const std::string& folder);
// One line; true if something was gripped and the aim meets its bars.
bool print_aim(const AimSummary& aim);
// Counts and every trial that did not end as predicted; true if at most one feasible trial failed, all others were
// refused rightly, and `least_feasible` cells could be tried at all.
bool print_grasp_summary(const std::vector<GraspCell>& cells, int least_feasible);

}  // namespace markservo::experiments
