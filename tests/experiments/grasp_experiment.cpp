// scripts/experiment grasp: the paper's table 3 by the whole robot: 75 cells (X and Y of the middle book, left, centre
// or right book), each predicted from robot.yaml alone, tried, and judged by the simulator's truth.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/workspace.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/grasp_report.hpp"
#include "tests/experiments/lift_truth.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/rig.hpp"

namespace markservo::experiments {
namespace {

constexpr std::array<double, 5> kX{-0.10, -0.05, 0.0, 0.05, 0.10};  // m, the middle book
constexpr std::array<double, 5> kY{0.35, 0.30, 0.25, 0.20, 0.15};   // m
constexpr int kMaxFrames = 60 * 30;                                 // a task that takes longer has failed
constexpr int kHoldFrames = 30;                                     // 1 s at 30 Hz, lifted
constexpr int kAfterRefusal = 30;                                   // frames, 1 s: nothing may move or touch later
constexpr int kLeastFeasible = 15;                                  // cells of the whole table

struct Book {
  char label;
  double offset;  // m, from the middle book along x (the paper's labels: L at +5 cm)
  const char* target;
};
constexpr std::array<Book, 3> kBooks{{{'L', 0.05, "yellow_book"}, {'C', 0.0, "red_book"}, {'R', -0.05, "blue_book"}}};

double farthest_joint(const std::vector<double>& a, const std::vector<double>& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) farthest = std::max(farthest, std::abs(a[i] - b[i]));
  return farthest;
}

bool truly_lifted(const SimTruth& truth, const std::string& target) {
  const SimBody* body = find_body(truth, target);
  return body != nullptr && held_free(*body);
}

GraspTrial run_trial(Rig& rig, const GraspCell& cell, const Book& book, double mark_height, std::int64_t seed,
                     Rig::Settings settings) {
  settings.emplace_back("books.x", cell.x);
  settings.emplace_back("books.y", cell.y);
  rig.reset(seed, settings);
  const std::vector<double> shaft_at_reset = rig.truth().shaft;
  rig.unlatch([&] { return rig.task_answered(); });
  TaskCommand start{};
  start.kind = TaskCommand::START;
  start.target = book.target;
  start.expected_known = true;
  start.p_CT_expected.x = cell.x + book.offset;
  start.p_CT_expected.y = cell.y;
  start.p_CT_expected.z = mark_height;
  rig.command(start);

  GraspTrial trial;
  trial.seed = seed;
  for (int frames = 0; frames < kMaxFrames; ++frames) {
    rig.step([&] { return rig.task_answered(); });
    if (rig.task().result != TaskState::RESULT_NONE) break;
  }
  const std::int8_t result = rig.task().result;
  trial.reason = rig.task().reason;
  if (result == TaskState::RESULT_LIFTED) {
    trial.result = "lifted";
    for (int frames = 0; frames < kHoldFrames; ++frames) {
      rig.step([&] { return rig.task_answered(); });
      if (!truly_lifted(rig.truth(), book.target)) {
        trial.result = "failed";
        trial.reason = "the task says lifted, but in truth the book is not held free in the air";
        break;
      }
    }
  } else if (result == TaskState::RESULT_REFUSED) {
    trial.result = "refused";
    for (int frames = 0; frames < kAfterRefusal; ++frames) {
      rig.step([&] { return rig.task_answered(); });
      trial.shaft_moved = std::max(trial.shaft_moved, farthest_joint(rig.truth().shaft, shaft_at_reset));
    }
  } else {
    trial.result = "failed";
    if (trial.reason.empty()) trial.reason = "the task did not end within 60 s";
  }
  trial.arm_touched = rig.truth().arm_touched;
  trial.touched = rig.truth().touched;
  return trial;
}

Rig::Settings parse_settings(const std::vector<std::string>& set) {
  Rig::Settings settings;
  for (const auto& entry : set) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos) throw ConfigurationError("--set is '" + entry + "'; allowed: name=value");
    const std::string name = entry.substr(0, equals);
    settings.emplace_back(name, parse_number("--set " + name, entry.substr(equals + 1)));
  }
  return settings;
}

struct Place {
  double x;  // m, the middle book
  double y;  // m
  Book book;
};

// The whole table, or what --cell says. Throws ConfigurationError.
std::vector<Place> choose_places(const std::vector<std::string>& only) {
  std::vector<Place> places;
  if (only.empty()) {
    for (const double x : kX) {
      for (const double y : kY) {
        for (const auto& book : kBooks) places.push_back({x, y, book});
      }
    }
    return places;
  }
  if (only.size() != 3) {
    throw ConfigurationError("--cell has " + std::to_string(only.size()) +
                             " parts; allowed: X,Y,BOOK, for example 0.0325,0.25,C");
  }
  for (const auto& book : kBooks) {
    if (only[2] != std::string(1, book.label)) continue;
    places.push_back({parse_number("--cell X", only[0]), parse_number("--cell Y", only[1]), book});
  }
  if (places.empty()) throw ConfigurationError("--cell BOOK is '" + only[2] + "'; allowed: L, C, R");
  return places;
}

bool experiment(const ExperimentOptions& options, const std::vector<std::string>& only,
                const std::vector<std::string>& set) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const Rig::Settings settings = parse_settings(set);
  const std::vector<Place> places = choose_places(only);
  for (const auto& place : places) {
    if (robot.find_mark(place.book.target) == nullptr) {
      throw ConfigurationError(options.robot_file + ": has no mark '" + place.book.target +
                               "'; the experiment takes it");
    }
  }

  Rig rig(options.lcm_url, "");
  Services services(options);
  for (const char* name : {"mark-detector", "target-locator", "visual-servo", "task-manager"}) {
    rig.wait_for_service(name, services.start(name));
  }
  rig.wait_for_service("simulator", services.start_simulator("JOINT_COMMAND,TASK_STATE"));
  rig.wait_for_world();

  std::vector<std::pair<GraspCell, Book>> work;
  const double mark_height = true_mark(rig.truth(), kBooks[1].target).value().z();
  for (const auto& place : places) {
    GraspCell cell;
    cell.x = place.x;
    cell.y = place.y;
    cell.book = place.book.label;
    const Eigen::Vector3d p_CT(place.x + place.book.offset, place.y, mark_height);
    cell.predicted = robot::name_of(robot::judge_grip(robot, *robot.find_mark(place.book.target), p_CT).verdict);
    work.emplace_back(cell, place.book);
  }

  ProgressBar progress(static_cast<int>(work.size()) * options.trials);
  std::vector<GraspCell> cells;
  for (auto& [cell, book] : work) {
    for (int i = 0; i < options.trials; ++i) {
      cell.trials.push_back(run_trial(rig, cell, book, mark_height, options.seed + i, settings));
      progress.advance(std::to_string(static_cast<int>(std::lround(cell.x * 100))) + " cm, " +
                       std::to_string(static_cast<int>(std::lround(cell.y * 100))) + " cm, " + cell.book + ": " +
                       cell.trials.back().result);
    }
    cells.push_back(cell);
    write_grasp_json(cells, options.out);
  }
  if (only.empty()) {
    print_beside_the_paper(cells);
    plot_heat_map(cells, options.out);
  }
  return print_grasp_summary(cells, only.empty() ? kLeastFeasible : 0);
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  std::vector<std::string> only;
  std::vector<std::string> set;
  return markservo::experiments::run_experiment(
      "The paper's grasp table by the whole robot in simulation", 2, argc, argv,
      [&](const markservo::experiments::ExperimentOptions& options) {
        return markservo::experiments::experiment(options, only, set);
      },
      [&](CLI::App& app) {
        const markservo::bus::Options add(app);
        add.option("--cell", only, "Only this cell: X,Y,BOOK in metres and L, C or R of the middle book's position")
            .delimiter(',');
        add.option("--set", set, "Simulator setting of every trial, name=value");
      });
}
