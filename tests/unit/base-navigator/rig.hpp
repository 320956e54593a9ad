#pragma once

// A simulated base before the navigator's core, step by step.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "services/base-navigator/navigator.hpp"
#include "tests/unit/base-navigator/drive_world.hpp"

namespace markservo::base_navigator::test {

inline robot::RobotDescription the_robot() {
  return robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
}

inline constexpr double kDegree = M_PI / 180.0;

class Rig {
 public:
  explicit Rig(std::uint64_t seed = 1, const NavigatorParameters& parameters = NavigatorParameters(),
               const WorldSettings& settings = WorldSettings())
      : navigator(robot, parameters), world(robot, settings, seed) {
    navigator.observe_stop(false, "", state);
  }

  static Goal goal_at(const geometry::PlanePose& X_WG, double clearance = 0.0, std::int64_t id = 1) {
    Goal goal;
    goal.session = 5;
    goal.id = id;
    goal.kind = GoalKind::kDrive;
    goal.pose = X_WG;
    goal.clearance = clearance;
    return goal;
  }

  void tell(const Goal& told) {
    goal = told;
    goal->utime = world.utime;
    navigator.observe(*goal, state);
  }

  // 20 ms: what came in is told, the answer is obeyed.
  Output step() {
    const OdometrySample odometry = world.odometry();
    if (odometry_lives) navigator.observe(odometry, state);
    if (sonars_live && world.scan_due()) navigator.observe(world.scan(), state);
    if (goal && sender_lives && steps_ % 10 == 0) tell(*goal);
    const PoseSample pose = world.pose();
    if (localiser_lives) navigator.observe(pose, state);
    Output output = navigator.step(state);
    watch(output);
    world.step(output.command);
    touched = touched || world.nearest() <= 0.0;
    nearest = std::min(nearest, world.nearest());
    ++steps_;
    last = output;
    return output;
  }

  Output run(double seconds) {
    Output output;
    for (int i = 0; i < steps_in(seconds); ++i) output = step();
    return output;
  }

  // Until the state is reached; s, or infinity after `at_most`.
  double run_until(DriveState wanted, double at_most) {
    for (int i = 0; i < steps_in(at_most); ++i) {
      if (step().status.state == wanted) return 0.02 * (i + 1);
    }
    return std::numeric_limits<double>::infinity();
  }

  double distance_to(const geometry::PlanePose& X_WG) const { return (world.X_WR.inverse() * X_WG).distance(); }
  double heading_error_to(const geometry::PlanePose& X_WG) const {
    return std::abs(geometry::wrapped(X_WG.heading - world.X_WR.heading));
  }

  static int steps_in(double seconds) { return static_cast<int>(std::lround(seconds / 0.02)); }

  robot::RobotDescription robot = the_robot();
  Navigator navigator;
  NavigatorState state;
  DriveWorld world;
  std::optional<Goal> goal;
  Output last;
  bool odometry_lives = true;
  bool sonars_live = true;
  bool localiser_lives = true;
  bool sender_lives = true;
  bool touched = false;
  double nearest = std::numeric_limits<double>::infinity();  // m, so far
  int direction_changes = 0;                                 // of the commanded speed
  double fastest = 0.0;
  double fastest_turn = 0.0;
  double hardest = 0.0;       // m/s^2, between commands, where these are ramped
  double hardest_turn = 0.0;  // rad/s^2

 private:
  void watch(const Output& output) {
    const Command& now = output.command;
    if (std::abs(now.speed) > 0.01) {
      const int sign = now.speed > 0.0 ? 1 : -1;
      if (direction_ != 0 && sign != direction_) ++direction_changes;
      direction_ = sign;
    }
    fastest = std::max(fastest, std::abs(now.speed));
    fastest_turn = std::max(fastest_turn, std::abs(now.turn_rate));
    const bool at_once = output.status.state == DriveState::kStale || output.status.state == DriveState::kStopped;
    if (!at_once) {
      hardest = std::max(hardest, std::abs(now.speed - before_.speed) / 0.02);
      hardest_turn = std::max(hardest_turn, std::abs(now.turn_rate - before_.turn_rate) / 0.02);
    }
    before_ = now;
  }

  Command before_;
  int direction_ = 0;
  int steps_ = 0;
};

}  // namespace markservo::base_navigator::test
