#pragma once

#include <optional>
#include <string>

namespace markservo::experiments {

// Where a case's robot differs from robot.yaml; what is absent stays.
struct RobotVariant {
  std::optional<double> spacing;         // m, of the hall's grid, which stays as wide as it was as far as it can
  std::optional<double> reading_radius;  // m
  std::optional<double> edge_softness;   // m
  std::optional<double> round_time;      // s
  std::optional<double> scale_sigma;     // of the encoders
  std::optional<double> drift_deg;       // per sqrt(m), of the encoders

  bool none() const {
    return !spacing && !reading_radius && !edge_softness && !round_time && !scale_sigma && !drift_deg;
  }
};

// The text of `robot_file` with the variant's values in place of its own.
// Throws ConfigurationError if the file cannot be read or lacks a section that the variant changes.
std::string robot_text(const std::string& robot_file, const RobotVariant& variant);

}  // namespace markservo::experiments
