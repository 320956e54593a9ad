// scripts/experiment grasp: the paper's table 3 by the whole robot: 75 cells (X and Y of the middle book, left, centre
// or right book), each predicted from robot.yaml alone, tried, and judged by the simulator's truth.

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/robot/workspace.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/grasp_report.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/rig.hpp"

namespace markservo::experiments {
namespace {

constexpr std::array<double, 5> kX{-0.10, -0.05, 0.0, 0.05, 0.10};  // m, the middle book
constexpr std::array<double, 5> kY{0.35, 0.30, 0.25, 0.20, 0.15};   // m
constexpr double kMarkHeight = 0.032;                               // m, above the lenses
constexpr int kMaxFrames = 60 * 30;                                 // a task that takes longer has failed
constexpr int kHoldFrames = 30;                                     // 1 s at 30 Hz, lifted
constexpr double kLifted = 0.020;                                   // m

struct Book {
  char label;
  double offset;  // m, from the middle book along x (the paper's labels: L at +5 cm)
  const char* target;
};
constexpr std::array<Book, 3> kBooks{{{'L', 0.05, "yellow_book"}, {'C', 0.0, "red_book"}, {'R', -0.05, "blue_book"}}};

// True if the truth shows the target lifted by the fingers and touching nothing else.
bool truly_lifted(const SimTruth& truth, const std::string& target) {
  for (const auto& body : truth.bodies) {
    if (body.name != target) continue;
    return body.height_gain >= kLifted && body.touches_left_finger && body.touches_right_finger && !body.touches_other;
  }
  return false;
}

GraspTrial run_trial(Rig& rig, const GraspCell& cell, const Book& book, int64_t seed, Rig::Settings settings) {
  settings.emplace_back("books.x", cell.x);
  settings.emplace_back("books.y", cell.y);
  rig.reset(seed, settings);
  rig.unlatch();
  TaskCommand start{};
  start.kind = TaskCommand::START;
  start.target = book.target;
  start.expected_known = true;
  start.p_CT_expected.x = cell.x + book.offset;
  start.p_CT_expected.y = cell.y;
  start.p_CT_expected.z = kMarkHeight;
  rig.command(start);

  GraspTrial trial;
  trial.seed = seed;
  for (int frames = 0; frames < kMaxFrames; ++frames) {
    rig.step([&] { return rig.task_answered(); });
    if (rig.task().result != TaskState::RESULT_NONE) break;
  }
  const int8_t result = rig.task().result;
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
  } else {
    trial.result = "failed";
    if (trial.reason.empty()) trial.reason = "the task did not end within 60 s";
  }
  trial.arm_touched = rig.truth().arm_touched;
  trial.touched = rig.truth().touched;
  return trial;
}

bool experiment(const ExperimentOptions& options, const std::vector<std::string>& only,
                const std::vector<std::string>& set) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  Rig::Settings settings;
  for (const auto& entry : set) {
    const auto equals = entry.find('=');
    if (equals == std::string::npos) throw std::runtime_error("--set " + entry + "; allowed: name=value");
    settings.emplace_back(entry.substr(0, equals), std::stod(entry.substr(equals + 1)));
  }
  std::vector<std::pair<GraspCell, Book>> work;
  const auto add = [&](double x, double y, const Book& book) {
    GraspCell cell;
    cell.x = x;
    cell.y = y;
    cell.book = book.label;
    const auto judgement = robot::judge_grip(robot, *robot.find_mark(book.target), {x + book.offset, y, kMarkHeight});
    cell.predicted = robot::name_of(judgement.verdict);
    work.emplace_back(cell, book);
  };
  if (only.empty()) {
    for (const double x : kX) {
      for (const double y : kY) {
        for (const auto& book : kBooks) add(x, y, book);
      }
    }
  } else {
    if (only.size() != 3) throw std::runtime_error("--cell takes X,Y,BOOK, for example 0.0325,0.25,C");
    for (const auto& book : kBooks) {
      if (only[2] == std::string(1, book.label)) add(std::stod(only[0]), std::stod(only[1]), book);
    }
  }

  Services services(options);
  services.start_simulator("JOINT_COMMAND,TASK_STATE");
  for (const char* name : {"mark-detector", "target-locator", "visual-servo", "task-manager"}) services.start(name);
  Rig rig(options.lcm_url, "");
  rig.wait_for_world();

  ProgressBar progress(static_cast<int>(work.size()) * options.trials);
  std::vector<GraspCell> cells;
  for (auto& [cell, book] : work) {
    for (int i = 0; i < options.trials; ++i) {
      cell.trials.push_back(run_trial(rig, cell, book, options.seed + i, settings));
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
  return print_grasp_summary(cells);
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
      [&](void* app) {
        auto* cli = static_cast<CLI::App*>(app);
        cli->add_option("--cell", only,
                        "Only this cell: X,Y,BOOK in metres and L, C or R of the middle book's position")
            ->delimiter(',');
        cli->add_option("--set", set, "Simulator setting of every trial, name=value");
      });
}
