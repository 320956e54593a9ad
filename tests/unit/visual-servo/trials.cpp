#include "tests/unit/visual-servo/trials.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/robot/arm_kinematics.hpp"
#include "tests/unit/visual-servo/test_robot.hpp"

namespace markservo::visual_servo::test {
namespace {

constexpr int kFramesAtMost = 300;
constexpr double kStartDistance = 0.15;  // m

// As task-manager asks for a grip (services/task-manager/parameters.hpp).
constexpr double kStandoff = 0.04;            // m, of at most 0.06 that both marks are seen from
constexpr double kStandoffTolerance = 0.004;  // m
constexpr double kGripTolerance = 0.0015;     // m

bool reachable_all_the_way(const robot::ArmDescription& arm, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr double kMargin = 0.05;
  for (int i = 0; i <= 20; ++i) {
    const Eigen::Vector3d p = from + (to - from) * (i / 20.0);
    if (robot::inverse_kinematics(arm, p, kMargin).status != robot::ReachStatus::kReachable) return false;
  }
  return true;
}

std::vector<Eigen::Vector3d> starts(const robot::ArmDescription& arm, const Eigen::Vector3d& goal) {
  const std::vector<Eigen::Vector3d> directions = {{0, -1, 0},      {-0.8, -0.6, 0}, {0.8, -0.6, 0}, {0, -0.6, -0.8},
                                                   {0, -0.8, 0.6},  {-1, 0, 0},      {1, 0, 0},      {0, 0, -1},
                                                   {-0.6, 0, -0.8}, {0.6, 0, -0.8}};
  std::vector<Eigen::Vector3d> found;
  for (const auto& direction : directions) {
    const Eigen::Vector3d start = goal + kStartDistance * direction;
    if (found.size() < 4 && reachable_all_the_way(arm, start, goal)) found.push_back(start);
  }
  return found;
}

// One goal: the grip point so far before the target's (m, along y), and its tolerance (m; 0: the servo's own).
struct Stage {
  double standoff = 0.0;
  double tolerance = 0.0;
};

Output step_once(ArmSimulator& arm, const ServoStateMachine& machine, State& state) {
  const PoseSample pose = arm.expose();
  for (const auto& sample : arm.take_joint_states()) machine.observe(sample, state);
  if (state.followed.goal()) repeat_goal(machine, state, pose.utime);
  Output output = machine.step(pose, state);
  arm.finish_frame(output.command);
  return output;
}

Trial run(const robot::RobotDescription& robot, const ServoStateMachine& machine, const SimulatorSettings& settings,
          const std::vector<Stage>& stages, const Eigen::Vector3d& start, const Eigen::Vector3d& goal_point,
          std::uint64_t seed) {
  ArmSimulator arm(robot, settings, seed);
  arm.place(robot::inverse_kinematics(*robot.arm, start, 0.0).q, goal_point - kGripFromTarget);
  State state;
  machine.observe_stop(false, "", state);
  for (int frame = 0; frame < 6; ++frame) step_once(arm, machine, state);  // the stack runs before the goal comes
  Trial trial;
  std::int64_t id = 0;
  for (const Stage& stage : stages) {
    Goal goal = grip_goal(state.joints.newest().utime, ++id);
    goal.p_TG_C.y() -= stage.standoff;
    goal.tolerance = stage.tolerance;
    machine.observe(goal, state);
    trial.converged = false;
    while (trial.frames < kFramesAtMost && !trial.converged) {
      ++trial.frames;
      trial.converged = step_once(arm, machine, state).status.state == ServoState::kConverged;
    }
  }
  trial.final_error = (arm.grip_point() - goal_point).norm();
  trial.y_overshoot = arm.deepest_y() - std::max(goal_point.y(), start.y());
  trial.sweep = arm.largest_sweep(goal_point);
  trial.jumps = arm.jumps();
  return trial;
}

std::vector<Trial> run_all(const robot::RobotDescription& robot, const Parameters& parameters,
                           const SimulatorSettings& settings, const std::vector<Stage>& stages, int seeds) {
  const ServoStateMachine machine(robot, parameters);
  std::vector<Trial> trials;
  for (const double x : {0.0, 0.05, 0.10}) {
    for (const double y : {0.20, 0.25, 0.30}) {
      const Eigen::Vector3d goal(x, y, -0.02);
      for (const auto& start : starts(*robot.arm, goal)) {
        for (int seed = 0; seed < seeds; ++seed) {
          trials.push_back(run(robot, machine, settings, stages, start, goal,
                               1000 * trials.size() + static_cast<std::uint64_t>(seed)));
        }
      }
    }
  }
  return trials;
}

}  // namespace

std::vector<Trial> run_trials(const robot::RobotDescription& robot, const Parameters& parameters,
                              const SimulatorSettings& settings, int seeds) {
  return run_all(robot, parameters, settings, {{}}, seeds);
}

std::vector<Trial> run_grasps(const robot::RobotDescription& robot, const Parameters& parameters,
                              const SimulatorSettings& settings, int seeds) {
  return run_all(robot, parameters, settings, {{kStandoff, kStandoffTolerance}, {0.0, kGripTolerance}}, seeds);
}

Summary summarise(const std::vector<Trial>& trials) {
  Summary summary;
  std::vector<int> frames;
  std::vector<double> errors;
  for (const auto& trial : trials) {
    summary.converged += trial.converged ? 1 : 0;
    frames.push_back(trial.frames);
    errors.push_back(trial.final_error);
    summary.error_mean += trial.final_error / static_cast<double>(trials.size());
    summary.y_overshoot = std::max(summary.y_overshoot, trial.y_overshoot);
    summary.jumps += trial.jumps;
    summary.sweep = std::max(summary.sweep, trial.sweep);
  }
  std::sort(frames.begin(), frames.end());
  std::sort(errors.begin(), errors.end());
  summary.trials = static_cast<int>(trials.size());
  summary.frames_median = frames[frames.size() / 2];
  summary.frames_max = frames.back();
  summary.error_p95 = errors[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(errors.size()))) - 1];
  summary.error_max = errors.back();
  return summary;
}

std::string header() {
  return "law            servos                     delay  converged  frames med/max  error mean/p95/max mm  beyond y "
         "mm  off line mm";
}

std::string row(const std::string& law, const SimulatorSettings& settings, const Summary& s) {
  char text[256];
  std::snprintf(text, sizeof text,
                "%-14s %-26s %d%s  %4d/%-4d   %5.0f/%-4d      %5.2f/%5.2f/%5.2f       %5.1f        %5.1f", law.c_str(),
                settings.servos.name.c_str(), settings.delay_frames, settings.delay_in_vision ? " seen" : " sent",
                s.converged, s.trials, s.frames_median, s.frames_max, 1e3 * s.error_mean, 1e3 * s.error_p95,
                1e3 * s.error_max, 1e3 * s.y_overshoot, 1e3 * s.sweep);
  return text;
}

}  // namespace markservo::visual_servo::test
