// scripts/bench latency: how long the services take from STEREO_FRAME to JOINT_COMMAND over a real bus, beside what the
// bus alone takes for as many messages of the same sizes; frames from a recording in memory, at a camera's rate.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "common/bus/bus_url.hpp"
#include "common/bus/network_check.hpp"
#include "common/bus/option_checks.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/bench/bench_marks.hpp"
#include "tests/bench/latency/latency_report.hpp"
#include "tests/bench/latency/player.hpp"
#include "tests/bench/latency/recorded_frames.hpp"
#include "tests/bench/latency/unpacking_cost.hpp"
#include "tests/experiments/child_process.hpp"
#include "tests/experiments/progress_bar.hpp"

namespace markservo::bench {
namespace {

using experiments::ChildProcess;

constexpr int kExitFailed = 1;
constexpr int kExitBadOptions = 2;

struct Options {
  std::string robot_file = "config/robot.yaml";
  std::string bin_folder = "build/release/bin";
  std::string lcm_url = bus::kDefaultUrl;
  double seconds = 6.0;
  bool json = false;
};

struct Kind {
  const char* key;
  Encoding encoding;
  double rate;  // Hz
};
constexpr Kind kKinds[] = {
    {"raw_30", Encoding::kRaw, 30.0}, {"raw_60", Encoding::kRaw, 60.0}, {"jpeg_30", Encoding::kJpeg, 30.0}};

constexpr double kRound = 2.0;  // s; chain and floor take turns, so that what the machine does falls on both

// Two seconds at 30 Hz: six scenes for a while each, and 110 MB, far more than any cache holds.
scenes::SceneParameters recording() {
  scenes::SceneParameters parameters;
  parameters.num_pairs = 60;
  parameters.num_layouts = 6;
  return parameters;
}

// Where the processes' words go; gone with the object unless kept.
class LogFolder {
 public:
  LogFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "latency-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
    path_ = name;
  }
  ~LogFolder() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove_all(path_, ignored);
  }
  LogFolder(const LogFolder&) = delete;
  LogFolder& operator=(const LogFolder&) = delete;

  void keep() { kept_ = true; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

using Processes = std::vector<std::unique_ptr<ChildProcess>>;

void start(Processes& processes, const Options& options, const LogFolder& logs, const std::string& name,
           const std::string& executable, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{(std::filesystem::path(options.bin_folder) / executable).string()};
  command.insert(command.end(), arguments.begin(), arguments.end());
  processes.push_back(std::make_unique<ChildProcess>(command, (logs.path() / (name + ".log")).string()));
}

void start_services(Processes& processes, const Options& options, const LogFolder& logs, const Route& route) {
  for (const Stage& stage : route.stages) {
    start(processes, options, logs, stage.name, stage.name,
          {"--robot-file", options.robot_file, "--lcm-url", route.url});
  }
}

void start_hops(Processes& processes, const Options& options, const LogFolder& logs, const Route& route,
                const std::vector<std::size_t>& sizes) {
  std::string from = route.frame_channel;
  for (std::size_t stage = 0; stage < route.stages.size(); ++stage) {
    const std::string& to = route.stages[stage].channel;
    start(processes, options, logs, route.stages[stage].name, "latency-hop",
          {"--lcm-url", route.url, "--from", from, "--to", to, "--bytes", std::to_string(sizes[stage])});
    from = to;
  }
}

std::vector<KindResult> play_rounds(const Options& options, Player& chain, Player& floor,
                                    const std::vector<scenes::StereoPair>& pairs, const geometry::StereoCamera& camera,
                                    UnpackingCost& unpacking) {
  std::vector<StereoFrame> raw = record_frames(pairs, camera, Encoding::kRaw);
  std::vector<StereoFrame> jpeg = record_frames(pairs, camera, Encoding::kJpeg);
  std::vector<KindResult> results;
  for (const Kind& kind : kKinds) {
    const FrameLedger nothing(chain.route().stages.size());
    results.push_back({kind.key, {nothing, nothing}, {nothing, nothing}});
  }
  const int num_rounds = std::max(1, static_cast<int>(std::lround(options.seconds / kRound)));
  const double round = options.seconds / num_rounds;
  experiments::ProgressBar progress((num_rounds + 1) * static_cast<int>(std::size(kKinds)));
  // The last round listens to every stage.
  for (int i = 0; i <= num_rounds; ++i) {
    for (std::size_t k = 0; k < std::size(kKinds); ++k) {
      std::vector<StereoFrame>& frames = kKinds[k].encoding == Encoding::kRaw ? raw : jpeg;
      const int count = std::max(1, static_cast<int>(std::lround(kKinds[k].rate * round)));
      if (i < num_rounds) {
        floor.play(frames, kKinds[k].rate, count, Listening::kAnswerOnly, results[k].floor.frames);
        chain.play(frames, kKinds[k].rate, count, Listening::kAnswerOnly, results[k].chain.frames);
      } else {
        floor.play(frames, kKinds[k].rate, count, Listening::kEveryStage, results[k].floor.watched);
        chain.play(frames, kKinds[k].rate, count, Listening::kEveryStage, results[k].chain.watched);
      }
      progress.advance(kKinds[k].key);
    }
    unpacking.measure(jpeg);
  }
  return results;
}

int run(const Options& options) {
  if (std::getenv("MARKSERVO_PRIVATE_NETWORK") == nullptr) {
    throw ConfigurationError(
        "the network is not a private one, and JOINT_COMMAND moves arms; run scripts/bench latency");
  }
  const Route chain_way = chain_route(options.lcm_url);
  const Route floor_way = floor_route(next_port(options.lcm_url));
  const std::string obstacle = bus::raw_frames_obstacle(options.lcm_url);
  if (!obstacle.empty()) std::cerr << "latency-bench: raw frames will be lost: " << obstacle << "\n";
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  if (!robot.arm) throw ConfigurationError(options.robot_file + ": arm: missing; allowed: an arm");
  std::cerr << "latency-bench: recording frames\n";
  const std::vector<scenes::StereoPair> pairs =
      scenes::render_pairs(robot.cameras, choose_marks(robot, options.robot_file), recording());
  std::vector<StereoFrame> first =
      record_frames({pairs.begin(), pairs.begin() + 1}, robot.cameras.stereo, Encoding::kRaw);

  LogFolder logs;
  try {
    Processes processes;
    std::cerr << "latency-bench: starting processes\n";
    start_services(processes, options, logs, chain_way);
    Player chain(chain_way, robot.arm->home);
    const std::vector<std::size_t> sizes = chain.wait_until_answered(first);
    start_hops(processes, options, logs, floor_way, sizes);
    Player floor(floor_way, robot.arm->home);
    floor.wait_until_answered(first);

    std::vector<std::string> stages;
    for (const Stage& stage : chain_way.stages) stages.push_back(stage.name);
    UnpackingCost unpacking;
    const auto results = play_rounds(options, chain, floor, pairs, robot.cameras.stereo, unpacking);
    nlohmann::ordered_json report = latency_json(results, stages);
    add_unpacking(report, unpacking.median_ms());
    std::cout << (options.json ? report.dump() + "\n" : latency_text(report));
    return 0;
  } catch (const std::exception&) {
    logs.keep();
    std::cerr << "latency-bench: what the processes said is in " << logs.path().string() << "\n";
    throw;
  }
}

}  // namespace
}  // namespace markservo::bench

int main(int argc, char** argv) {
  using namespace markservo;
  bench::Options options;
  CLI::App app("Times the services from STEREO_FRAME to JOINT_COMMAND, beside the bus alone.");
  app.add_option("--robot-file", options.robot_file, "The robot's description: cameras, marks and arm")
      ->capture_default_str();
  app.add_option("--bin", options.bin_folder, "Where the services' executables are")->capture_default_str();
  app.add_option("--lcm-url", options.lcm_url, "LCM bus of the services; that of the empty processes is the next port")
      ->envname("MARKSERVO_LCM_URL")
      ->capture_default_str();
  app.add_option("--seconds", options.seconds, "Of each kind of frames, through each")
      ->check(markservo::bus::Within(1.0, 600.0))
      ->capture_default_str();
  app.add_flag("--json", options.json, "Print one JSON object");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bench::kExitBadOptions;
  }
  try {
    return bench::run(options);
  } catch (const ConfigurationError& error) {
    std::cerr << "latency-bench: " << error.what() << "\n";
    return bench::kExitBadOptions;
  } catch (const std::exception& error) {
    std::cerr << "latency-bench: " << error.what() << "\n";
    return bench::kExitFailed;
  }
}
