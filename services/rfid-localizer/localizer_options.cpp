#include "services/rfid-localizer/localizer_options.hpp"

#include "common/bus/number_options.hpp"
#include "common/bus/options.hpp"
#include "common/geometry/plane_pose.hpp"

namespace markservo::rfid_localizer {

void add_localizer_options(CLI::App& app, LocalizerOptions& options) {
  const bus::Options add(app);
  const bus::NumberOptions number(app);
  add.option("--method", options.method,
             "Whose pose ROBOT_POSE carries: filter, or paper: weighted average, Hough direction, compensated "
             "delay. Its paper part carries the paper's values either way")
      .one_of({"filter", "paper"})
      .show_default();
  add.option("--stop-device", options.stop_device, "The base's name in STOP_STATE: whose WHEEL_ODOMETRY counts")
      .show_default();
  add.option("--tag-field", options.tag_field, "Field of floor tags in robot.yaml; default: its floor_tags.in_use");
  add.option("--delay", options.delay, "From the middle of a reader's round to its arrival, s; default: robot.yaml's")
      .within(0.0, 5.0);
  add.option("--delay-sigma", options.delay_sigma,
             "How well that is known, s; default: robot.yaml's. The filter improves on it when the speed changes")
      .within(0.0, 1.0);
  add.option("--start-heading", options.start_heading_deg, "The robot's heading at the start, deg; default: not known")
      .within(-360.0, 360.0);
  number("--start-heading-sigma", options.start_heading_sigma_deg, "How well that is known, deg", 0.1, 60.0);
  number("--slip-margin", options.slip_margin, "On robot.yaml's drift of the heading: what floors add to it", 1.0,
         10.0);
  number("--lost-sigma", options.trust.largest_sigma, "Position less well known counts as lost, m", 0.01, 10.0);
  number("--silence", options.trust.silence, "Lost without any round of the reader for so long, s", 0.2, 60.0);
}

LocalizerParameters localizer_parameters(const LocalizerOptions& options, const robot::RobotDescription& robot) {
  LocalizerParameters parameters = parameters_of(robot, options.slip_margin);
  parameters.trust = options.trust;
  if (options.delay) parameters.delay.mean = parameters.paper.delay = *options.delay;
  if (options.delay_sigma) parameters.delay.sigma = *options.delay_sigma;
  if (options.start_heading_deg) {
    parameters.start_heading =
        HeadingPrior{geometry::radians(*options.start_heading_deg), geometry::radians(options.start_heading_sigma_deg)};
  }
  return parameters;
}

}  // namespace markservo::rfid_localizer
