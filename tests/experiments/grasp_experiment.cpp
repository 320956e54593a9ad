// scripts/experiment grasp: the paper's table 3 by the whole robot: 75 cells (X and Y of the middle book, left, centre
// or right book), each predicted from robot.yaml alone, tried, and judged by the simulator's truth.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>

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
constexpr const char* kStopsAtEdge = "stops-at-edge";
constexpr const char* kRunsHome = "runs-home";

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

struct Work {
  GraspCell cell;
  robot::MarkDescription target;  // with a grip
  Eigen::Vector3d p_CT;           // m, expected
};

GraspTrial run_trial(Rig& rig, const Work& work, std::int64_t seed, Rig::Settings settings) {
  settings.emplace_back("books.x", work.cell.x);
  settings.emplace_back("books.y", work.cell.y);
  rig.reset(seed, settings);
  const std::vector<double> shaft_at_reset = rig.truth().shaft;
  rig.unlatch([&] { return rig.task_answered(); });
  TaskCommand start{};
  start.kind = TaskCommand::START;
  start.target = work.target.name;
  start.expected_known = true;
  start.p_CT_expected.x = work.p_CT.x();
  start.p_CT_expected.y = work.p_CT.y();
  start.p_CT_expected.z = work.p_CT.z();
  rig.command(start);

  GraspTrial trial;
  trial.seed = seed;
  AimWatch aim(work.target.name, work.target.grip->p_TG);
  for (int frames = 0; frames < kMaxFrames; ++frames) {
    rig.step([&] { return rig.task_answered(); });
    aim.observe(rig.truth(), rig.task().state);
    if (rig.task().result != TaskState::RESULT_NONE) break;
  }
  const std::int8_t result = rig.task().result;
  trial.reason = rig.task().reason;
  trial.aim = aim.aim();
  if (result == TaskState::RESULT_LIFTED) {
    trial.result = "lifted";
    for (int frames = 0; frames < kHoldFrames; ++frames) {
      rig.step([&] { return rig.task_answered(); });
      if (!truly_lifted(rig.truth(), work.target.name)) {
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

std::vector<Work> plan_work(const robot::RobotDescription& robot, const std::vector<Place>& places,
                            double mark_height) {
  std::vector<Work> planned;
  for (const auto& place : places) {
    Work work{{}, *robot.find_mark(place.book.target), {place.x + place.book.offset, place.y, mark_height}};
    work.cell.x = place.x;
    work.cell.y = place.y;
    work.cell.book = place.book.label;
    work.cell.predicted = robot::name_of(robot::judge_grip(robot, work.target, work.p_CT).verdict);
    planned.push_back(work);
  }
  return planned;
}

// Tries and judges all cells; `whole`: they are the paper's table. True if every bar is met.
bool try_cells(Rig& rig, const std::vector<Work>& planned, bool whole, const ExperimentOptions& options,
               const Rig::Settings& settings) {
  std::filesystem::create_directories(options.out);
  ProgressBar progress(static_cast<int>(planned.size()) * options.trials);
  std::vector<GraspCell> cells;
  for (const Work& work : planned) {
    GraspCell cell = work.cell;
    for (int i = 0; i < options.trials; ++i) {
      cell.trials.push_back(run_trial(rig, work, options.seed + i, settings));
      progress.advance(std::to_string(static_cast<int>(std::lround(cell.x * 100))) + " cm, " +
                       std::to_string(static_cast<int>(std::lround(cell.y * 100))) + " cm, " + cell.book + ": " +
                       cell.trials.back().result);
    }
    cells.push_back(cell);
    write_grasp_json(cells, options.out);
  }
  if (whole) {
    print_beside_the_paper(cells);
    plot_heat_map(cells, options.out);
  }
  const bool as_predicted = print_grasp_summary(cells, whole ? kLeastFeasible : 0);
  const bool to_grip =
      std::any_of(cells.begin(), cells.end(), [](const GraspCell& cell) { return cell.predicted == "feasible"; });
  const bool aimed = !to_grip || print_aim(summarise_aim(cells));
  return as_predicted && (aimed || whole);  // the aim's bar is for a place that the hand enters from before it
}

// What --cell, --set and --deadband say.
struct GraspOptions {
  std::vector<std::string> only;
  std::vector<std::string> set;
  std::vector<std::string> deadbands;
};

bool experiment(const ExperimentOptions& options, const GraspOptions& grasp) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const Rig::Settings settings = parse_settings(grasp.set);
  const std::vector<Place> places = choose_places(grasp.only);
  for (const auto& place : places) {
    const robot::MarkDescription* target = robot.find_mark(place.book.target);
    if (target == nullptr || !target->grip) {
      throw ConfigurationError(options.robot_file + ": has no mark '" + place.book.target +
                               "' with a grip; the experiment takes it");
    }
  }

  Rig rig(options.lcm_url, "");
  Services services(options);
  for (const char* name : {"mark-detector", "target-locator", "visual-servo", "task-manager"}) {
    rig.wait_for_service(name, services.start(name));
  }
  rig.wait_for_service("simulator", services.start_simulator("JOINT_COMMAND,TASK_STATE"));
  rig.wait_for_world();

  const double mark_height = true_mark(rig.truth(), kBooks[1].target).value().z();
  const std::vector<Work> planned = plan_work(robot, places, mark_height);
  const bool whole = grasp.only.empty();
  if (grasp.deadbands.empty()) return try_cells(rig, planned, whole, options, settings);
  bool met = true;
  for (const auto& name : grasp.deadbands) {
    std::printf("\ndeadband: %s\n", name.c_str());
    ExperimentOptions apart = options;
    apart.out = std::filesystem::path(options.out) / name;
    Rig::Settings with_deadband = settings;
    with_deadband.emplace_back("servo.deadband_kind", name == kRunsHome ? 1.0 : 0.0);
    met = try_cells(rig, planned, whole, apart, with_deadband) && met;
  }
  return met;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  markservo::experiments::GraspOptions grasp;
  return markservo::experiments::run_experiment(
      "The paper's grasp table by the whole robot in simulation", 2, argc, argv,
      [&](const markservo::experiments::ExperimentOptions& options) {
        return markservo::experiments::experiment(options, grasp);
      },
      [&](CLI::App& app) {
        const markservo::bus::Options add(app);
        add.option("--cell", grasp.only,
                   "Only this cell: X,Y,BOOK in metres and L, C or R of the middle book's position")
            .delimiter(',');
        add.option("--set", grasp.set, "Simulator setting of every trial, name=value");
        add.option("--deadband", grasp.deadbands,
                   "Kinds of the servos' deadband, each tried by itself, its results in a folder of --out")
            .delimiter(',')
            .one_of({markservo::experiments::kStopsAtEdge, markservo::experiments::kRunsHome});
      });
}
