// fault-campaign: draws faults for a robot at work, one seed a trial, and judges each trial by its history alone.

#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "common/robot/robot_description.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/system/fault_campaign/child.hpp"
#include "tests/system/fault_campaign/plan.hpp"
#include "tests/system/fault_campaign/results.hpp"

namespace {

using namespace markservo;
using namespace markservo::campaign;
namespace fs = std::filesystem;

struct Options {
  int trials = 5;
  std::int64_t seed = 1;
  std::vector<std::int64_t> seeds;  // instead
  std::string shard = "1/1";
  bool resume = false;
  bool keep = false;
  bool plan_only = false;
  int most = 2;
  int draws = 4;
  std::string out = "logs/experiment-faults";
  std::string repository = ".";
  std::string build_dir;
  std::string commit = "unknown";
  std::string judge_only;
  std::string kind;
  std::string phase;
};

Bars bars_of(const std::string& robot_file) {
  const robot::RobotDescription robot = robot::load_robot_description(robot_file);
  Bars bars;
  for (const auto& joint : robot.arm->joints) {
    bars.joint_min.push_back(joint.min);
    bars.joint_max.push_back(joint.max);
    bars.joint_speed.push_back(joint.speed);
  }
  bars.base_speed = robot.base->speed_max;
  bars.base_turn_rate = robot.base->turn_rate_max;
  return bars;
}

std::optional<nlohmann::json> read_json(const fs::path& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  return nlohmann::json::parse(file, nullptr, false);
}

void write_json(const fs::path& path, const nlohmann::json& json) {
  const fs::path fresh = path.string() + ".new";
  std::ofstream(fresh) << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  fs::rename(fresh, path);
}

class Campaign {
 public:
  explicit Campaign(Options options)
      : options_(std::move(options)), bars_(bars_of(options_.repository + "/config/robot.yaml")) {}

  int run() {
    if (!options_.judge_only.empty()) return judge_again();
    if (options_.plan_only) return print_plans();
    fs::create_directories(options_.out);
    std::vector<nlohmann::json> results;
    for (const std::int64_t seed : seeds()) {
      results.push_back(result_for(seed));
      std::cout << line_of(results.back()) << std::endl;
      for (const auto& [name, evidence] : results.back().at("breaches").items()) {
        std::cout << "      " << name << ": " << evidence.at(0).get<std::string>() << std::endl;
      }
      write_json(fs::path(options_.out) / "faults.json", campaign_of(options_.commit, results));
    }
    const nlohmann::json campaign = campaign_of(options_.commit, results);
    std::cout << table_of(campaign);
    return bars_met(campaign, options_.most) ? 0 : 1;
  }

 private:
  // This shard's.
  std::vector<std::int64_t> seeds() const {
    std::vector<std::int64_t> all = options_.seeds;
    for (int i = 0; all.size() < static_cast<std::size_t>(options_.trials) && options_.seeds.empty(); ++i) {
      all.push_back(options_.seed + i);
    }
    const int part = std::stoi(options_.shard);
    const int parts = std::stoi(options_.shard.substr(options_.shard.find('/') + 1));
    std::vector<std::int64_t> mine;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (static_cast<int>(i) % parts == part - 1) mine.push_back(all[i]);
    }
    return mine;
  }

  int print_plans() const {
    for (const std::int64_t seed : seeds()) {
      const Plan plan = plan_of(seed, 0);
      std::cout << seed << " " << plan.phase;
      for (const FaultPlan& fault : plan.faults) std::cout << " " << json_of(fault).dump();
      std::cout << "\n";
    }
    return 0;
  }

  nlohmann::json result_for(std::int64_t seed) {
    const fs::path folder = fs::path(options_.out) / ("seed-" + std::to_string(seed));
    if (options_.resume) {
      const auto known = read_json(folder / "result.json");
      if (known && known->is_object() && known->value("commit", options_.commit) == options_.commit) return *known;
    }
    fs::remove_all(folder);
    nlohmann::json history = nlohmann::json::array();  // of draws that proved nothing
    nlohmann::json result;
    for (int draw = 0; draw < options_.draws; ++draw) {
      fs::remove_all(folder);
      fs::create_directories(folder);
      result = carry_out(seed, draw, folder);
      // What may never break is a breach wherever it does, whether or not the draw proves what it should.
      if (proves_what_it_should(result) || breaks_what_may_never_break(result)) break;
      history.push_back({{"draw", draw},
                         {"phase", result.at("phase")},
                         {"faults", result.at("faults")},
                         {"broken", result.at("broken")},
                         {"breaches", result.at("breaches")},
                         {"problem", result.at("problem")}});
    }
    result["drawn_again"] = history;
    result["commit"] = options_.commit;
    if (result.at("broken").empty() && !options_.keep) fs::remove_all(folder);
    fs::create_directories(folder);
    write_json(folder / "result.json", result);
    return result;
  }

  nlohmann::json carry_out(std::int64_t seed, int draw, const fs::path& folder) {
    std::vector<std::string> command{options_.repository + "/scripts/private-network",
                                     experiments::sibling_executable("fault-trial"),
                                     "--seed",
                                     std::to_string(seed),
                                     "--draw",
                                     std::to_string(draw),
                                     "--repository",
                                     options_.repository,
                                     "--build-dir",
                                     options_.build_dir,
                                     "--out",
                                     folder.string()};
    if (!options_.kind.empty()) {
      command.insert(command.end(),
                     {"--kind", options_.kind, "--phase", options_.phase.empty() ? "idle" : options_.phase});
    }
    // Each trial has a network of its own, whichever this is.
    Child child(command, (folder / "trial.txt").string(), {"MARKSERVO_PRIVATE_NETWORK=", "MARKSERVO_LCM_URL="});
    int status = 0;
    waitpid(child.pid(), &status, 0);
    const auto trial = read_json(folder / "trial.json");
    if (!trial || !trial->is_object()) {
      return {{"seed", seed},
              {"draw", draw},
              {"phase", ""},
              {"phase_reached", false},
              {"struck", false},
              {"faults", nlohmann::json::array()},
              {"problem", "the trial itself failed; see " + (folder / "trial.txt").string()},
              {"broken", nlohmann::json::array()},
              {"judged", nlohmann::json::object()},
              {"breaches", nlohmann::json::object()},
              {"task", nlohmann::json::object()}};
    }
    return result_of(*trial, judge(timeline_of(load_history(folder.string())), bars_));
  }

  int judge_again() const {
    const fs::path folder(options_.judge_only);
    const auto trial = read_json(folder / "trial.json");
    if (!trial || !trial->is_object()) throw std::runtime_error(folder.string() + "/trial.json: cannot be read");
    const nlohmann::json result = result_of(*trial, judge(timeline_of(load_history(folder.string())), bars_));
    std::cout << result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    return result.at("broken").empty() ? 0 : 1;
  }

  Options options_;
  Bars bars_;
};

void add_options(CLI::App& app, Options& options) {
  app.add_option("--trials", options.trials, "Seeds in all")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--seed", options.seed, "Of the first trial")->capture_default_str();
  app.add_option("--seeds", options.seeds, "These seeds instead, separated by commas")->delimiter(',');
  app.add_option("--shard", options.shard, "I/N: the I-th of N parts of the seeds")
      ->check([](const std::string& text) {
        int part = 0;
        int parts = 0;
        char rest = 0;
        const bool good = std::sscanf(text.c_str(), "%d/%d%c", &part, &parts, &rest) == 2 && part >= 1 && part <= parts;
        return good ? std::string() : "'" + text + "'; allowed: I/N with I from 1 to N";
      })
      ->capture_default_str();
  app.add_flag("--resume", options.resume, "Seeds that have a result of this commit in DIR are not run again");
  app.add_flag("--keep", options.keep, "Keep every trial's history, not only those that broke something");
  app.add_option("--most", options.most, "I7 to I11 may each be broken in so many seeds")->capture_default_str();
  app.add_option("--draws", options.draws, "How often a seed is drawn whose fault strikes nothing")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  app.add_option("--out", options.out, "Folder for the results")->capture_default_str();
  app.add_option("--repository", options.repository, "Where scripts/ and config/ are")->capture_default_str();
  app.add_option("--build-dir", options.build_dir,
                 "Has bin/SERVICE: the stack that is tried; default: this program's own");
  app.add_option("--commit", options.commit, "Of the stack that is tried, for the report");
  app.add_option("--judge-only", options.judge_only, "Judge a kept trial's folder again, and run nothing");
  app.add_flag("--plan", options.plan_only, "Print what the seeds draw at first, and run nothing");
  app.add_option("--kind", options.kind, "This fault alone, its numbers drawn: kind[:channel|service|variant]...");
  app.add_option("--phase", options.phase, "With --kind: the phase (default idle)");
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Faults, drawn by seed, for a robot at work: what must hold, holds");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    const fs::path own = fs::path(experiments::sibling_executable(".")).lexically_normal();
    if (options.build_dir.empty()) options.build_dir = own.parent_path().parent_path().string();
    options.build_dir = fs::absolute(options.build_dir).lexically_normal().string();
    options.repository = fs::canonical(options.repository).string();
    options.out = fs::absolute(options.out).lexically_normal().string();
    return Campaign(options).run();
  } catch (const std::exception& error) {
    std::cerr << "fault-campaign: " << error.what() << "\n";
    return 2;
  }
}
