#include "tests/experiments/experiment.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <stdexcept>

#include "common/bus/bus_url.hpp"
#include "common/bus/service.hpp"
#include "common/robot/configuration_error.hpp"
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
  CLI::App app(description);
  app.add_option("--trials", options.trials, "Trials of each case")->check(CLI::Range(1, 10000))->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the first trial")->capture_default_str();
  app.add_option("--out", options.out, "Folder for the results")->capture_default_str();
  app.add_option("--robot-file", options.robot_file, "The robot's description")->capture_default_str();
  app.add_option("--scene", options.scene, "The simulated scene")->capture_default_str();
  app.add_option("--lcm-url", options.lcm_url, "LCM bus")->envname("MARKSERVO_LCM_URL")->capture_default_str();
  if (add_options) add_options(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return app.exit(request);
  } catch (const CLI::Error& error) {
    std::cerr << error.what() << "; see --help\n";
    return bus::kExitBadConfiguration;
  }
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
