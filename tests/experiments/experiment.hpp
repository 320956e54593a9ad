#pragma once

// What every experiment's main() shares: its options and the services it starts.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "tests/experiments/child_process.hpp"

namespace CLI {
class App;
}

namespace markservo::experiments {

class ProgressBar;

struct ExperimentOptions {
  int trials = 1;
  std::int64_t seed = 1;
  std::string out = "logs/experiment";  // folder of the results
  std::string robot_file = "config/robot.yaml";
  std::string scene = "config/scenes/shelf.yaml";
  std::string lcm_url;
};

// Parses `argc`, `argv` (--trials, --seed, --out, --robot-file, --scene, --lcm-url, and what `add_options` adds) and
// runs `body`; exit code 0 if it returns true (every bar met), 1 if false, 2 for bad options or settings, 3 if the rig
// fails.
int run_experiment(const std::string& description, int default_trials, int argc, char** argv,
                   const std::function<bool(const ExperimentOptions&)>& body,
                   const std::function<void(CLI::App& app)>& add_options = {});

// Calls `work` for each number from 0 to `count` - 1, two at a time, and has `progress` say of each that ends that it
// is of `what`. What `work` throws is thrown when all are done.
void run_in_parallel(std::size_t count, const std::string& what, ProgressBar& progress,
                     const std::function<void(std::size_t)>& work);

// The services of an experiment, found beside its own executable, each with its log in `options.out`.
class Services {
 public:
  explicit Services(const ExperimentOptions& options) : options_(options) {}

  // Starts `name` with the common options and `arguments`; its process.
  pid_t start(const std::string& name, const std::vector<std::string>& arguments = {});
  // The simulator in lockstep, waiting for `channels` and the experiment.
  pid_t start_simulator(const std::string& channels, const std::vector<std::string>& settings = {});
  // Runs `name` until it ends by itself; its exit code.
  int run(const std::string& name, const std::vector<std::string>& arguments) const;
  // Ends the last started service.
  void stop_last() { running_.pop_back(); }

 private:
  std::vector<std::string> command(const std::string& name, const std::vector<std::string>& arguments) const;
  std::string log_file(const std::string& name) const;

  ExperimentOptions options_;
  std::vector<std::unique_ptr<ChildProcess>> running_;
};

// The number that `text` is, all of it. Throws ConfigurationError that names `what`.
double parse_number(const std::string& what, const std::string& text);

// Where `name` lies beside this executable.
std::string sibling_executable(const std::string& name);

}  // namespace markservo::experiments
