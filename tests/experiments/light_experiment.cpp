// scripts/experiment light: does the detector keep its marks while the light changes, with and without adapting to it?

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/experiments/experiment.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/light/light_trial.hpp"

namespace markservo::experiments {
namespace {

constexpr int kNumFrames = 126;  // of a sequence: 4 s at 30 Hz
constexpr double kSigma = 3.0;   // grey levels
constexpr int kLostBar = 3;      // frames in a row
constexpr int kNumVariants = 2;  // adapting, and not

struct Sum {
  int visible = 0;
  int found = 0;
  int longest_lost = 0;
  int lost_marks = 0;  // marks of a sequence that were lost for longer than the bar
  int wrong = 0;
  int confused = 0;
  double least_separability = 1.0;

  void add(const light::MarkScore& score) {
    visible += score.visible;
    found += score.found;
    longest_lost = std::max(longest_lost, score.longest_lost);
    lost_marks += score.longest_lost > kLostBar ? 1 : 0;
    wrong += score.wrong;
    confused += score.confused;
    least_separability = std::min(least_separability, score.least_separability);
  }
  bool met() const { return longest_lost <= kLostBar && confused == 0; }
};

nlohmann::ordered_json json_of(const Sum& sum) {
  return {{"visible_frames", sum.visible},
          {"found_frames", sum.found},
          {"longest_lost_frames", sum.longest_lost},
          {"marks_lost", sum.lost_marks},
          {"wrong_frames", sum.wrong},
          {"confused_frames", sum.confused},
          {"least_separability", sum.least_separability}};
}

bool experiment(const ExperimentOptions& options) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const std::vector<std::string>& kinds = light::light_kinds();
  // By kind, adapting first; and by mark, adapting.
  std::vector<std::array<Sum, kNumVariants>> sums(kinds.size());
  std::vector<Sum> of_mark(robot.marks.size());
  ProgressBar progress(options.trials * static_cast<int>(kinds.size()));
  for (int i = 0; i < options.trials; ++i) {
    const auto seed = static_cast<unsigned>(options.seed + i);
    light::LightScene scene(robot.cameras, robot.marks, kSigma, seed);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const auto sequence = light::light_sequence(kinds[k], kNumFrames, seed * 100U + static_cast<unsigned>(k));
      for (std::size_t variant = 0; variant < kNumVariants; ++variant) {
        mark_detector::Parameters parameters;
        parameters.adapt = variant == 0;
        const light::Trial trial = light::run_trial(scene, sequence, robot.marks, parameters);
        for (std::size_t m = 0; m < robot.marks.size(); ++m) {
          sums[k][variant].add(trial.marks[m]);
          if (variant == 0) of_mark[m].add(trial.marks[m]);
        }
      }
      progress.advance(kinds[k] + ", seed " + std::to_string(seed));
    }
  }

  nlohmann::ordered_json cases = nlohmann::ordered_json::array();
  bool all_met = true;
  std::printf("%-11s %-8s %8s %13s %11s %9s %10s %13s\n", "light", "adapts", "found", "longest lost", "marks lost",
              "wrong", "confused", "separability");
  const auto row = [](const std::string& name, const char* adapts, const Sum& sum) {
    std::printf("%-11s %-8s %7.2f%% %6d frames %11d %9d %10d %13.2f", name.c_str(), adapts,
                100.0 * sum.found / std::max(1, sum.visible), sum.longest_lost, sum.lost_marks, sum.wrong, sum.confused,
                sum.least_separability);
  };
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    for (std::size_t variant = 0; variant < kNumVariants; ++variant) {
      const Sum& sum = sums[k][variant];
      const bool adapts = variant == 0;
      row(kinds[k], adapts ? "yes" : "no", sum);
      std::printf("%s\n", !adapts ? "" : sum.met() ? "  met" : "  missed");
      if (adapts) all_met = all_met && sum.met();
      nlohmann::ordered_json json{{"light", kinds[k]}, {"adapts", adapts}};
      json.update(json_of(sum));
      cases.push_back(json);
    }
  }
  nlohmann::ordered_json marks = nlohmann::ordered_json::array();
  for (std::size_t m = 0; m < robot.marks.size(); ++m) {
    row(robot.marks[m].name, "yes", of_mark[m]);
    std::printf("\n");
    nlohmann::ordered_json json{{"mark", robot.marks[m].name}};
    json.update(json_of(of_mark[m]));
    marks.push_back(json);
  }
  std::printf("bar: no mark lost for more than %d frames, none confused with another; %d sequences of %d frames each\n",
              kLostBar, options.trials, kNumFrames);
  std::ofstream(std::filesystem::path(options.out) / "light.json")
      << nlohmann::ordered_json{{"trials", options.trials}, {"frames", kNumFrames}, {"cases", cases}, {"marks", marks}}
             .dump(2)
      << "\n";
  return all_met;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  return markservo::experiments::run_experiment("Marks kept while the light changes, by the scenes' truth", 10, argc,
                                                argv, markservo::experiments::experiment);
}
