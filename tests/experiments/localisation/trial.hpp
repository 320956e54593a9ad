#pragma once

// One drive of a case, localised by the real rfid-localizer and scored.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/experiments/localisation/cases.hpp"
#include "tests/experiments/localisation/live_score.hpp"
#include "tests/experiments/localisation/paper_score.hpp"

namespace markservo::experiments {

// A live score beside what no filter can beat, at the same samples.
struct BoundedScore {
  LiveScore live;
  std::vector<double> bound_all;      // m, mean radial error of the bound's Gaussian
  std::vector<double> bound_settled;  // m
  std::vector<double> bound_heading;  // rad, mean absolute error, while driving after settling
};

// What the pictures show of one run.
struct RunPicture {
  std::vector<Eigen::Vector2d> tags;  // m, the map's
  std::vector<PathPoint> truth;       // over the scored time
  std::vector<PoseEstimate> estimates;
  std::vector<PaperRead> reads;
  std::vector<PaperError> paper;
};

// Without encoders ROBOT_POSE comes once a round. A consumer moves it on at its own speed until the next one.
struct FreeScore {
  BoundedScore sampled;    // at the same 50 Hz as with encoders
  BoundedScore published;  // when it is sent
};

struct TrialResult {
  std::int64_t seed = 0;
  BoundedScore with_encoders;
  std::optional<FreeScore> without_encoders;
  std::vector<PaperError> paper;
  double delay_error = 0.0;        // s, at the end: told less true
  double delay_error_bound = 0.0;  // s, standard deviation
  RunPicture picture;
};

struct TrialFiles {
  std::string robot_file;  // of the case's variant
  std::string folder;      // for logs
  bool keep_logs = false;
};

// Throws std::runtime_error if the localizer fails or answers nothing.
TrialResult run_trial(const LocalisationCase& the_case, const robot::RobotDescription& robot, const TrialFiles& files,
                      std::int64_t seed);

}  // namespace markservo::experiments
