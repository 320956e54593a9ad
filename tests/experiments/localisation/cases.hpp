#pragma once

// The table of cases: which course, on which floor, with which reader, encoders and faults, and what is asked of it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/simulator/base/base_rig.hpp"
#include "tests/experiments/localisation/robot_variant.hpp"

namespace markservo::experiments {

enum class CourseKind { kStraight, kStraightStanding, kDiagonal, kStatic, kHall, kCircle, kStopAndGo };

// What a case must reach; absent: reported only. Lengths in m, mean radial error of the live pose.
struct CaseBars {
  std::optional<double> settled_mean;         // after the first second
  std::optional<double> all_mean;             // from the first read on
  std::optional<double> free_mean;            // without encoders, after the first second
  std::optional<double> bound_ratio;          // ours over the bound, with encoders
  std::optional<double> hall_ratio;           // ours over ours on the undisturbed hall
  std::optional<double> heading_mean;         // rad, absolute, while driving after the first second
  std::optional<double> delay_error;          // s, mean absolute error of the delay at the end
  std::optional<double> paper_gain_axis;      // share of the measured error that compensation must take away, each axis
  std::optional<double> not_localised_share;  // of the samples after settling, that they are not LOCALISED
  bool nees = false;                          // 2 to 4.5
  bool must_not_diverge = false;

  // Nothing is asked of it: reported only.
  bool none() const {
    return !settled_mean && !all_mean && !free_mean && !bound_ratio && !hall_ratio && !heading_mean && !delay_error &&
           !paper_gain_axis && !not_localised_share && !nees && !must_not_diverge;
  }
};

struct LocalisationCase {
  std::string name;     // what --case takes, and the begin of its files' names
  std::string course;   // straight, diagonal, static, hall, circle, stop_and_go
  std::string variant;  // what is different from the course's plain case
  CourseKind kind = CourseKind::kHall;
  double speed = 0.40;  // m/s
  RobotVariant robot;
  simulator::BaseRigParameters rig;   // faults that the localizer is not told of; the encoders' errors are robot.yaml's
  bool without_encoders = false;      // run a second time on the reads alone
  int trials_factor = 1;              // times the trials asked for
  double settling = 1.0;              // s that are told apart, from the first read on or from where the course says
  std::optional<double> delay_sigma;  // s, what the localizer is told; absent: robot.yaml's
  CaseBars bars;
};

// All of them; the plain hall before those that are compared with it.
std::vector<LocalisationCase> localisation_cases();

// The one of that name. Throws ConfigurationError that lists the names.
LocalisationCase find_case(const std::string& name);

}  // namespace markservo::experiments
