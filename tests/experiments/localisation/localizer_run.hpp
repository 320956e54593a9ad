#pragma once

// The real rfid-localizer on a drive's log.

#include <markservo/RobotPose.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/experiments/localisation/live_score.hpp"
#include "tests/experiments/localisation/paper_score.hpp"
#include "tests/experiments/localisation/recorded_drive.hpp"

namespace markservo::experiments {

// What the localizer is told besides robot.yaml.
struct Told {
  std::optional<double> start_heading;  // rad in W
  double start_heading_sigma = 0.0;     // rad
  std::optional<double> delay_sigma;    // s
};

struct LocalizerRun {
  std::string robot_file;
  std::string tag_field;
  std::string files;  // path and begin of the names of its log, input and output
  bool with_odometry = true;
  bool keep_files = false;
  Told told;
};

struct Localised {
  std::vector<RobotPose> messages;      // one or more
  std::vector<PoseEstimate> estimates;  // the same, plain
};

// Throws std::runtime_error if the localizer fails or answers nothing.
Localised localise(const Drive& drive, const LocalizerRun& run);

// The paper's value at every read that found a tag, and ours at the same times. `p_RF` (m): the antenna in R.
std::vector<PaperRead> paper_reads(const Localised& localised, const Eigen::Vector2d& p_RF);

}  // namespace markservo::experiments
