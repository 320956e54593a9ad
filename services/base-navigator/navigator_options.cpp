#include "services/base-navigator/navigator_options.hpp"

#include <string>

#include "common/bus/number_options.hpp"
#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/base-navigator/navigator.hpp"

namespace markservo::base_navigator {
namespace {

void add_motion_options(CLI::App& app, MotionParameters& motion) {
  const bus::NumberOptions number(app);
  number("--speed", motion.speed, "At most, m/s; a goal may ask for less; never above robot.yaml's", 0.05, 10.0);
  number("--turn-rate", motion.turn_rate, "At most, rad/s; never above robot.yaml's", 0.1, 20.0);
  number("--acceleration", motion.acceleration, "m/s^2; robot.yaml's is used to brake for obstacles", 0.05, 10.0);
  number("--turn-acceleration", motion.turn_acceleration, "rad/s^2", 0.2, 50.0);
}

void add_passage_options(CLI::App& app, PassageParameters& passage) {
  const bus::NumberOptions number(app);
  number("--clearance", passage.clearance, "Kept from what the sonars see, m, for goals whose clearance is 0", 0.01,
         2.0);
  number("--turn-clearance", passage.turn_clearance, "Likewise while turning on the spot, at most, m", 0.01, 2.0);
  number("--reaction", passage.reaction, "From an echo to the brakes, s", 0.02, 2.0);
  number("--free-for", passage.free_for, "The way must be free for, before it goes on, s", 0.0, 10.0);
}

void add_arrival_options(CLI::App& app, ArrivalParameters& arrival) {
  const bus::Options add(app);
  const bus::NumberOptions number(app);
  number("--tolerance", arrival.position, "Arrived within, m", 0.002, 0.5);
  number("--heading-tolerance", arrival.heading, "Arrived within, rad", 0.005, 0.5);
  number("--coarse-tolerance", arrival.coarse_position, "Will do after all corrections, m", 0.002, 1.0);
  number("--coarse-heading-tolerance", arrival.coarse_heading, "Will do after all corrections, rad", 0.005, 1.0);
  add.option("--corrections", arrival.corrections, "At the goal, before it takes what it has or gives up")
      .in_range(0, 20)
      .show_default();
  number("--settle-time", arrival.settle_time, "Standing before the pose is judged, s", 0.1, 10.0);
}

void add_trust_options(CLI::App& app, TrustParameters& trust) {
  const bus::NumberOptions number(app);
  number("--pose-age", trust.pose_age, "ROBOT_POSE older than that is not driven by, s", 0.05, 2.0);
  number("--scan-age", trust.scan_age, "SONAR_SCAN older than that is not driven by, s", 0.05, 2.0);
  number("--goal-age", trust.goal_age, "A goal not repeated for longer is not followed, s", 0.25, 5.0);
  number("--position-sigma", trust.position_sigma, "Of a pose to drive by, at most, m", 0.01, 1.0);
  number("--heading-sigma", trust.heading_sigma, "Of a pose to drive by, at most, rad", 0.02, 3.0);
}

void add_explore_options(CLI::App& app, ExploreParameters& explore) {
  const bus::Options add(app);
  const bus::NumberOptions number(app);
  add.option("--explore", explore.enabled, "Creep straight on (or back) to learn the heading when only that is unknown")
      .show_default();
  number("--explore-speed", explore.speed, "m/s", 0.02, 0.5);
  number("--explore-way", explore.distance, "m, at most", 0.05, 2.0);
}

}  // namespace

void add_navigator_options(CLI::App& app, NavigatorParameters& parameters) {
  add_motion_options(app, parameters.motion);
  add_passage_options(app, parameters.passage);
  add_arrival_options(app, parameters.manoeuvre.arrival);
  add_trust_options(app, parameters.trust);
  add_explore_options(app, parameters.explore);
}

void require_consistent(const NavigatorParameters& parameters) {
  const ArrivalParameters& arrival = parameters.manoeuvre.arrival;
  if (arrival.coarse_position < arrival.position || arrival.coarse_heading < arrival.heading) {
    throw ConfigurationError("--coarse-tolerance, --coarse-heading-tolerance: allowed: no less than --tolerance (" +
                             std::to_string(arrival.position) + " m) and --heading-tolerance (" +
                             std::to_string(arrival.heading) + " rad)");
  }
}

}  // namespace markservo::base_navigator
