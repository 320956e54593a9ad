#pragma once

// The default robot before the shelf, for tests.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/arm_kinematics.hpp"
#include "services/simulator/model/time_step.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/world/simulation.hpp"
#include "services/simulator/world/world.hpp"

namespace markservo::simulator {

inline robot::RobotDescription test_robot() {
  return robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
}

inline Scene test_scene() {
  return load_scene(std::string(MARKSERVO_SOURCE_DIR) + "/config/scenes/shelf.yaml", test_robot());
}

// The defaults of lockstep with ideal servos, and these on top.
inline Settings test_settings(const std::vector<std::pair<std::string, double>>& changes = {}) {
  Settings settings = default_settings(test_robot(), test_scene(), true);
  settings.servo.deadband_deg = 0.0;
  for (const auto& [name, value] : changes) set_value(settings, name, value);
  return settings;
}

inline World test_world(const Settings& settings, std::uint64_t seed = 1) {
  return World(test_robot(), test_scene(), settings, seed);
}

// A person's STOP or its reset, each one new.
inline void ask(Simulation& simulation, bool reset) {
  static std::int64_t id = 0;
  simulation.hear_stop({{1, ++id, simulation.utime()}, reset, "test"});
}
inline void release(Simulation& simulation) {
  ask(simulation, true);
}
inline void stop(Simulation& simulation) {
  ask(simulation, false);
}

inline void wait(World& world, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kTimeStep));
  for (int i = 0; i < steps; ++i) world.step();
}

inline ArmCommand posture(const robot::JointVector& q, double opening, double speed = 1.0) {
  ArmCommand command;
  command.position = q;
  command.speed_limit = robot::JointVector::Constant(speed);
  command.gripper_opening = opening;
  command.gripper_force = 25.0;
  return command;
}

// Leads the grip point along a straight line, at about 3 cm/s.
inline bool move_straight(World& world, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double opening) {
  const robot::ArmDescription arm = *test_robot().arm;
  const int points = 1 + static_cast<int>((to - from).norm() / 0.001);
  for (int i = 1; i <= points; ++i) {
    const auto ik = robot::inverse_kinematics(arm, from + (to - from) * i / points, 0.0);
    if (ik.status != robot::ReachStatus::kReachable) return false;
    world.command(posture(ik.q, opening, 3.0));
    wait(world, 0.032);
  }
  return true;
}

inline const BodyTruth& body_of(const WorldTruth& truth, const std::string& name) {
  for (const auto& body : truth.bodies) {
    if (body.name == name) return body;
  }
  throw std::invalid_argument("no body " + name);
}

inline const MarkTruth& mark_of(const WorldTruth& truth, const std::string& name) {
  for (const auto& mark : truth.marks) {
    if (mark.name == name) return mark;
  }
  throw std::invalid_argument("no mark " + name);
}

}  // namespace markservo::simulator
