// scripts/experiment servo: how many frames the servo loop needs from 15 cm away and how far from the goal it ends, by
// the simulator's truth; ideal servos, deadband, deadband and backlash, one to three frames of delay, our law and the
// paper's.

#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "common/bus/options.hpp"
#include "common/geometry/plane_pose.hpp"
#include "common/robot/arm_kinematics.hpp"
#include "common/robot/workspace.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/lift_truth.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/rig.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

// The hand ends before the spines, so that a law that misses pushes no book.
const Eigen::Vector3d kGoalFromTarget(0.0, -0.035, -0.052);  // m, axes of C
constexpr double kStartDistance = 0.15;                      // m
constexpr double kTolerance = 0.001;                         // m
constexpr int kMaxFrames = 240;                              // 8 s at 30 Hz: not converged counts as that many

struct Servos {
  std::string name;
  double deadband_deg;
  double backlash_deg;
  int frames_bar;
  double error_bar;  // m, p95
};
const std::vector<Servos> kServos = {
    {"ideal", 0.0, 0.0, 35, 0.0010}, {"deadband", 0.3, 0.0, 60, 0.0012}, {"backlash", 0.3, 1.0, 150, 0.0015}};

struct Start {
  Eigen::Vector2d book;  // m, x and y of the middle book's mark
  robot::JointVector q;  // rad
};

struct Trial {
  bool converged = false;
  int frames = 0;
  double final_error = 0.0;  // m, true grip point from the true goal
};

// True if both cameras see the whole hand mark, and the whole target mark above it: what is seen at both ends of a
// straight way is seen along it.
bool both_marks_in_view(const robot::RobotDescription& robot, const robot::JointVector& q, double hand_size,
                        const Eigen::Vector3d& p_CT, double target_size) {
  const Eigen::Isometry3d X_CM = robot::hand_mark_pose(*robot.arm, q);
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  X_CT.translation() = p_CT;
  constexpr double kPlate = 1.5;  // the hand mark's plate, of the mark's edge
  const double hand_top = (X_CM.translation().z() + 0.5 * kPlate * hand_size) / X_CM.translation().y();
  const double target_bottom = (p_CT.z() - 0.5 * target_size) / p_CT.y();
  return hand_top < target_bottom &&
         robot::view_margin_px(robot.cameras, X_CM, hand_size) >= robot.workspace.view_margin_px &&
         robot::view_margin_px(robot.cameras, X_CT, target_size) >= robot.workspace.view_margin_px;
}

// A start 15 cm from the goal, at which the arm can be and both cameras see both marks; 15 cm fit into what both see
// only towards far books.
Start draw_start(const robot::RobotDescription& robot, double mark_height, double hand_size, double target_size,
                 std::mt19937& random) {
  std::uniform_real_distribution<double> book_x(-0.04, 0.11);
  std::uniform_real_distribution<double> book_y(0.28, 0.335);
  std::normal_distribution<double> normal;
  for (int tries = 0; tries < 1000000; ++tries) {
    const Eigen::Vector2d book(book_x(random), book_y(random));
    const Eigen::Vector3d p_CT(book.x(), book.y(), mark_height);
    const Eigen::Vector3d p_CG_goal = p_CT + kGoalFromTarget;
    const double margin = robot.workspace.joint_margin;
    const auto goal = robot::inverse_kinematics(*robot.arm, p_CG_goal, margin);
    if (goal.status != robot::ReachStatus::kReachable) continue;
    if (!both_marks_in_view(robot, goal.q, hand_size, p_CT, target_size)) continue;
    const Eigen::Vector3d away = Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    if (away.y() > 0.0) continue;  // towards the books
    const auto start = robot::inverse_kinematics(*robot.arm, p_CG_goal + kStartDistance * away, margin);
    if (start.status != robot::ReachStatus::kReachable) continue;
    if (!both_marks_in_view(robot, start.q, hand_size, p_CT, target_size)) continue;
    return {book, start.q};
  }
  throw std::runtime_error("no start 15 cm from a goal with the hand in view; is robot.yaml's geometry sound?");
}

Trial run_trial(Rig& rig, const robot::RobotDescription& robot, const std::string& target, const Start& start,
                const Servos& servos, int delay_frames, std::int64_t seed) {
  rig.reset(seed, {{"books.x", start.book.x()},
                   {"books.y", start.book.y()},
                   {"servo.deadband_deg", servos.deadband_deg},
                   {"servo.deadband_kind", static_cast<double>(seed % 2)},
                   {"servo.backlash_deg", servos.backlash_deg},
                   {"servo.delay_frames", delay_frames},
                   {"arm.start_yaw_deg", geometry::degrees(start.q[0])},
                   {"arm.start_shoulder_deg", geometry::degrees(start.q[1])},
                   {"arm.start_elbow_deg", geometry::degrees(start.q[2])}});
  rig.unlatch([&] { return rig.servo_answered(); });
  for (int i = 0; i < 3; ++i) rig.step([&] { return rig.servo_answered(); });
  ServoGoal goal{};
  goal.kind = ServoGoal::SERVO;
  goal.target = target;
  goal.p_TG_C.x = kGoalFromTarget.x();
  goal.p_TG_C.y = kGoalFromTarget.y();
  goal.p_TG_C.z = kGoalFromTarget.z();
  goal.tolerance = kTolerance;
  goal.gripper_opening = robot.arm->gripper.opening_max;
  rig.give_goal(goal);

  Trial trial;
  while (trial.frames < kMaxFrames && !trial.converged) {
    rig.step([&] { return rig.servo_answered(); });
    ++trial.frames;
    // The status of the frame before: answers to this one are still on their way.
    trial.converged = rig.servo().goal_id == rig.goal_id() && rig.servo().state == ServoStatus::CONVERGED;
  }
  trial.final_error = (vector(rig.truth().p_CG) - (true_mark(rig.truth(), target).value() + kGoalFromTarget)).norm();
  return trial;
}

const robot::MarkDescription& mark_of_role(const robot::RobotDescription& robot, robot::MarkRole role) {
  for (const auto& mark : robot.marks) {
    if (mark.role == role) return mark;
  }
  throw std::runtime_error("the robot needs a mark on its hand and a target");
}

bool experiment(const ExperimentOptions& options, const std::vector<std::string>& laws) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const robot::MarkDescription& target_mark = mark_of_role(robot, robot::MarkRole::kTarget);
  const std::string target = target_mark.name;
  const double hand_size = mark_of_role(robot, robot::MarkRole::kManipulator).size;

  Rig rig(options.lcm_url, "");
  Services services(options);
  for (const char* name : {"mark-detector", "target-locator"}) rig.wait_for_service(name, services.start(name));
  rig.wait_for_service("simulator", services.start_simulator(channels::kJointCommand.name));
  rig.wait_for_world();
  const double mark_height = true_mark(rig.truth(), target).value().z();

  ProgressBar progress(static_cast<int>(laws.size() * kServos.size()) * 3 * options.trials);
  nlohmann::json cases = nlohmann::json::array();
  bool all_met = true;
  std::printf("%-9s %-14s %5s  %9s %7s %7s  %10s %10s  %s\n", "servos", "law", "delay", "converged", "frames", "max",
              "error p50", "p95", "bar");
  for (const auto& law : laws) {
    rig.wait_for_service("visual-servo", services.start("visual-servo", {"--law", law}));
    for (const auto& servos : kServos) {
      for (int delay = 1; delay <= 3; ++delay) {
        std::mt19937 random(static_cast<std::uint32_t>(options.seed));  // the same starts for every case
        std::vector<double> frames;
        std::vector<double> errors;
        int converged = 0;
        for (int i = 0; i < options.trials; ++i) {
          const Start start = draw_start(robot, mark_height, hand_size, target_mark.size, random);
          const Trial trial = run_trial(rig, robot, target, start, servos, delay, options.seed + i);
          frames.push_back(trial.frames);
          errors.push_back(trial.final_error);
          converged += trial.converged ? 1 : 0;
          progress.advance(law + ", " + servos.name + ", delay " + std::to_string(delay));
        }
        const double frames_max = maximum(frames);
        const double p95 = percentile(errors, 0.95);
        const bool met = frames_max <= servos.frames_bar && p95 <= servos.error_bar;
        if (law == "resolved-rate") all_met = all_met && met;
        std::printf("%-9s %-14s %5d  %5d/%-3d %7.0f %7.0f  %7.2f mm %7.2f mm  %d frames, %.1f mm: %s\n",
                    servos.name.c_str(), law.c_str(), delay, converged, options.trials, median(frames), frames_max,
                    1e3 * median(errors), 1e3 * p95, servos.frames_bar, 1e3 * servos.error_bar, met ? "met" : "missed");
        std::fflush(stdout);
        cases.push_back({{"servos", servos.name},
                         {"law", law},
                         {"delay_frames", delay},
                         {"trials", options.trials},
                         {"converged", converged},
                         {"frames_median", median(frames)},
                         {"frames_max", frames_max},
                         {"final_median_m", median(errors)},
                         {"final_p95_m", p95},
                         {"final_max_m", maximum(errors)}});
        std::ofstream(std::filesystem::path(options.out) / "servo.json")
            << nlohmann::json{{"cases", cases}}.dump(2) << "\n";
      }
    }
    services.stop_last();
  }
  return all_met;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  std::vector<std::string> laws{"resolved-rate", "paper"};
  return markservo::experiments::run_experiment(
      "Frames and final error of the servo loop, by the simulator's truth", 12, argc, argv,
      [&](const markservo::experiments::ExperimentOptions& options) {
        return markservo::experiments::experiment(options, laws);
      },
      [&](CLI::App& app) {
        const markservo::bus::Options add(app);
        add.option("--law", laws, "Laws to try").delimiter(',').one_of({"resolved-rate", "paper"}).show_default();
      });
}
