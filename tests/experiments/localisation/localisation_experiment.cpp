// scripts/experiment localisation: how well the pose is known while the base drives over the tag field; ours beside the
// paper's method and beside the Fisher bound of the same drives.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/localisation/localisation_plots.hpp"
#include "tests/experiments/localisation/localisation_report.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

namespace fs = std::filesystem;

CaseResult run_case(const LocalisationCase& the_case, const ExperimentOptions& options, ProgressBar& progress) {
  TrialFiles files;
  files.robot_file = options.robot_file;
  files.folder = (fs::path(options.out) / "logs").string();
  fs::create_directories(files.folder);
  if (!the_case.robot.none()) {
    files.robot_file = (fs::path(options.out) / ("robot-" + the_case.name + ".yaml")).string();
    std::ofstream(files.robot_file) << robot_text(options.robot_file, the_case.robot);
  }
  const robot::RobotDescription robot = robot::load_robot_description(files.robot_file);
  if (!robot.base || !robot.rfid || !robot.floor_tags) {
    throw ConfigurationError(files.robot_file + ": lacks base, rfid or floor_tags; the experiment needs all three");
  }
  const auto count = static_cast<std::size_t>(options.trials) * static_cast<std::size_t>(the_case.trials_factor);
  std::vector<TrialResult> trials(count);
  run_in_parallel(count, the_case.name, progress, [&](std::size_t i) {
    TrialFiles own = files;
    own.keep_logs = i == 0;
    trials[i] = run_trial(the_case, robot, own, options.seed + static_cast<std::int64_t>(i));
  });

  CaseResult result;
  result.the_case = the_case;
  for (const TrialResult& trial : trials) result.add(trial);
  return result;
}

bool experiment(const ExperimentOptions& options, const std::vector<std::string>& names) {
  std::vector<LocalisationCase> cases;
  for (const auto& name : names) cases.push_back(find_case(name));
  if (cases.empty()) cases = localisation_cases();

  int total = 0;
  for (const auto& the_case : cases) total += options.trials * the_case.trials_factor;
  ProgressBar progress(total);
  std::vector<CaseResult> results;
  std::optional<double> hall_mean;
  for (const auto& the_case : cases) {
    results.push_back(run_case(the_case, options, progress));
    if (the_case.name == "hall") hall_mean = mean(results.back().with_encoders.settled);
  }

  print_cases(results);
  print_paper_table(results);
  for (const CaseResult& result : results) {
    const std::string& name = result.the_case.name;
    if (name == "straight" || name == "diagonal") plot_errors(result, options.out);
    if (name == "straight" || name == "diagonal" || name == "hall") plot_plan(result, options.out);
  }
  write_localisation_json(results, options.out);
  const bool met = print_verdicts(results, hall_mean);
  std::printf(
      "the bars are set for 50 trials: fewer may miss them by chance. Results and pictures (SVG, for a browser): %s\n",
      options.out.c_str());
  return met;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  using namespace markservo::experiments;
  std::vector<std::string> names;
  return run_experiment(
      "The robot's pose from floor tags and encoders: ours, the paper's method and the Fisher bound", 50, argc, argv,
      [&names](const ExperimentOptions& options) { return experiment(options, names); },
      [&names](CLI::App& app) {
        markservo::bus::Options(app).option("--case", names, "One case, by name; may be repeated; default: all");
      });
}
