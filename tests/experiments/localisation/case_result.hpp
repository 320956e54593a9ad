#pragma once

// All runs of a case together.

#include <optional>
#include <vector>

#include "tests/experiments/localisation/cases.hpp"
#include "tests/experiments/localisation/trial.hpp"

namespace markservo::experiments {

struct LiveTotals {
  std::vector<double> all;            // m, radial, every sample of every run
  std::vector<double> settled;        // m
  std::vector<double> bound_all;      // m
  std::vector<double> bound_settled;  // m
  std::vector<double> heading;        // rad, absolute
  std::vector<double> bound_heading;  // rad, mean absolute
  std::vector<double> nees;
  int not_localised = 0;  // samples after settling
  int without_pose = 0;   // samples
  int diverged = 0;       // runs

  void add(const BoundedScore& score);
  double not_localised_share() const;  // of the samples after settling
  double bound_ratio() const;          // ours over the bound, means after settling
};

struct CaseResult {
  LocalisationCase the_case;
  int trials = 0;
  LiveTotals with_encoders;
  std::optional<LiveTotals> free_sampled;    // without encoders, at 50 Hz
  std::optional<LiveTotals> free_published;  // the same when ROBOT_POSE is sent
  std::vector<PaperError> paper;
  std::vector<double> delay_errors;  // s, absolute, at the end of each run
  double delay_bound = 0.0;          // s, mean standard deviation
  std::vector<std::int64_t> diverged_seeds;
  RunPicture picture;  // of the first run

  void add(const TrialResult& trial);
};

// Which component of a paper's error; kAlong is that in the direction of the true motion.
enum class Axis { kX, kY, kAlong };
enum class PaperValue { kMeasured, kCompensated, kFused };

// The components (m, signed) of the errors from the `first_read`-th read of a run on.
std::vector<double> components(const std::vector<PaperError>& errors, PaperValue value, Axis axis, int first_read);

// The axes that the paper's table has for the course: y on the straight one, else x and y.
std::vector<Axis> table_axes(const LocalisationCase& the_case);

// The share of the mean measured error that compensation takes away.
double compensation_gain(const std::vector<PaperError>& errors, Axis axis, int first_read);

inline constexpr int kSettledRead = 4;  // the direction needs a few averages

}  // namespace markservo::experiments
