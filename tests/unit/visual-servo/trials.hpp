#pragma once

// Servoing trials over the workspace: targets x starts 15 cm away x seeds.

#include <string>
#include <vector>

#include "tests/unit/visual-servo/arm_simulator.hpp"

namespace markservo::visual_servo::test {

struct Trial {
  bool converged = false;
  int frames = 0;            // until CONVERGED
  double final_error = 0.0;  // m, by truth, when it converged (or gave up)
  double y_overshoot = 0.0;  // m, beyond the goal
  double sweep = 0.0;        // m, off the straight line
  int jumps = 0;             // commands that a driver would refuse as not continuing those before them
};

struct Summary {
  int trials = 0;
  int converged = 0;
  double frames_median = 0.0;
  int frames_max = 0;
  double error_mean = 0.0;   // m
  double error_p95 = 0.0;    // m
  double error_max = 0.0;    // m
  double y_overshoot = 0.0;  // m, largest
  double sweep = 0.0;        // m, largest
  int jumps = 0;             // of all trials
};

// All goals (x 0..0.10, y 0.20..0.30, z -0.02) from four starts each, `seeds` times.
std::vector<Trial> run_trials(const robot::RobotDescription& robot, const Parameters& parameters,
                              const SimulatorSettings& settings, int seeds);

// The same in two goals, as an object is gripped: to within 4 mm 4 cm before it, then to within 1.5 mm.
std::vector<Trial> run_grasps(const robot::RobotDescription& robot, const Parameters& parameters,
                              const SimulatorSettings& settings, int seeds);

Summary summarise(const std::vector<Trial>& trials);

// One line of the table.
std::string row(const std::string& law, const SimulatorSettings& settings, const Summary& summary);
std::string header();

}  // namespace markservo::visual_servo::test
