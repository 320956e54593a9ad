#pragma once

#include <optional>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/rfid-localizer/localizer.hpp"
#include "services/rfid-localizer/robot_parameters.hpp"

namespace CLI {
class App;
}

namespace markservo::rfid_localizer {

struct LocalizerOptions {
  std::string method = "filter";  // or "paper"
  std::string stop_device = "base";
  std::string tag_field;                    // empty: the one in use
  std::optional<double> delay;              // s; absent: robot.yaml's
  std::optional<double> delay_sigma;        // s; likewise
  std::optional<double> start_heading_deg;  // absent: not known
  double start_heading_sigma_deg = 5.0;
  double slip_margin = kSlipMargin;
  TrustParameters trust;
};

void add_localizer_options(CLI::App& app, LocalizerOptions& options);

// Of a robot that has a reader and a map of tags.
LocalizerParameters localizer_parameters(const LocalizerOptions& options, const robot::RobotDescription& robot);

}  // namespace markservo::rfid_localizer
