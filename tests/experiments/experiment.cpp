#include "tests/experiments/experiment.hpp"

#include <atomic>
#include <cmath>
#include <future>
#include <iostream>
#include <mutex>
#include <stdexcept>

#include "common/bus/bus_url.hpp"
#include "common/bus/command_line.hpp"
#include "common/bus/exit_code.hpp"
#include "common/bus/named_bus.hpp"
#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/rig.hpp"

namespace markservo::experiments {

std::string sibling_executable(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

int run_experiment(const std::string& description, int default_trials, int argc, char** argv,
                   const std::function<bool(const ExperimentOptions&)>& body,
                   const std::function<void(CLI::App& app)>& add_options) {
  ExperimentOptions options;
  options.trials = default_trials;
  options.lcm_url = bus::kDefaultUrl;
  bus::CommandLine command_line("", description);
  const bus::Options add(command_line.app());
  add.option("--trials", options.trials, "Trials of each case").in_range(1, 10000).show_default();
  add.option("--seed", options.seed, "Seed of the first trial").show_default();
  add.option("--out", options.out, "Folder for the results").show_default();
  add.option("--robot-file", options.robot_file, "The robot's description").show_default();
  add.option("--scene", options.scene, "The simulated scene").show_default();
  bus::add_lcm_url(add, options.lcm_url, "LCM bus");
  if (add_options) add_options(command_line.app());
  if (const auto exit_code = command_line.parse(argc, argv)) return *exit_code;
  try {
    std::filesystem::create_directories(options.out);
    return body(options) ? 0 : 1;
  } catch (const ConfigurationError& error) {
    std::cerr << error.what() << "\n";
    return bus::kExitBadConfiguration;
  } catch (const std::runtime_error& error) {
    std::cerr << "experiment failed: " << error.what() << "; the services' logs are in " << options.out << "\n";
    return bus::kExitBusUnavailable;
  }
}

void run_in_parallel(std::size_t count, const std::string& what, ProgressBar& progress,
                     const std::function<void(std::size_t)>& work) {
  constexpr int kWorkers = 2;
  std::atomic<std::size_t> next{0};
  std::mutex on_progress;
  const auto work_on = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      work(i);
      const std::lock_guard<std::mutex> lock(on_progress);
      progress.advance(what);
    }
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < kWorkers; ++i) workers.push_back(std::async(std::launch::async, work_on));
  for (auto& worker : workers) worker.get();
}

double parse_number(const std::string& what, const std::string& text) {
  std::size_t used = 0;
  double value = NAN;
  try {
    value = std::stod(text, &used);
  } catch (const std::logic_error&) {
    used = 0;
  }
  if (used == 0 || used != text.size() || !std::isfinite(value)) {
    throw ConfigurationError(what + ": '" + text + "' is not a number; allowed: a finite number");
  }
  return value;
}

std::string Services::log_file(const std::string& name) const {
  return (std::filesystem::path(options_.out) / (name + ".log")).string();
}

std::vector<std::string> Services::command(const std::string& name, const std::vector<std::string>& arguments) const {
  std::vector<std::string> words{sibling_executable(name), "--robot-file", options_.robot_file};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

pid_t Services::start(const std::string& name, const std::vector<std::string>& arguments) {
  std::vector<std::string> words = command(name, arguments);
  words.insert(words.end(), {"--lcm-url", options_.lcm_url});
  running_.push_back(std::make_unique<ChildProcess>(words, log_file(name)));
  return running_.back()->pid();
}

pid_t Services::start_simulator(const std::string& channels, const std::vector<std::string>& settings) {
  std::vector<std::string> arguments{
      "--scene", options_.scene, "--lockstep", "--wait-for",
      channels.empty() ? channels::kSimControl.name : channels + "," + channels::kSimControl.name};
  for (const auto& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
  return start("simulator", arguments);
}

int Services::run(const std::string& name, const std::vector<std::string>& arguments) const {
  ChildProcess process(command(name, arguments), log_file(name));
  return process.wait();
}

}  // namespace markservo::experiments
