// scripts/experiment hidden: marks in full view and marks that something nearer hides up to half, through the real
// detector and locator, scored against the truth: is the published covariance true?

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/experiments/experiment.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/scenes/hidden_marks.hpp"

namespace markservo::experiments {
namespace {

using scenes::Consistency;
using scenes::HiddenMarkDraw;
using scenes::Hiding;

// What every case must keep.
constexpr double kLeastWithin = 0.98;        // of the located, squared Mahalanobis distance below chi-square's 99%
constexpr double kLeastNees = 2.0;           // mean, 3 degrees of freedom
constexpr double kMostNees = 4.5;            // likewise
constexpr double kMostMedianSigma = 1.5e-3;  // m

bool holds(const Consistency& result) {
  return result.located > 0 && result.within >= kLeastWithin && result.mean_nees >= kLeastNees &&
         result.mean_nees <= kMostNees && result.median_worst_sigma <= kMostMedianSigma;
}

nlohmann::ordered_json to_json(const Consistency& result) {
  return {{"drawn", result.drawn},
          {"detected", result.detected},
          {"located", result.located},
          {"within_chi_square_99", result.within},
          {"mean_nees", result.mean_nees},
          {"median_sigma_m", result.median_sigma},
          {"median_worst_sigma_m", result.median_worst_sigma},
          {"median_error_m", result.median_error},
          {"p95_error_m", result.p95_error},
          {"holds", holds(result)}};
}

nlohmann::ordered_json to_json(const HiddenMarkDraw& draw) {
  const Eigen::Vector3d sigma = draw.location.covariance.diagonal().cwiseSqrt();
  return {{"seed", draw.seed},
          {"hidden_left", draw.hidden_left},
          {"hidden_right", draw.hidden_right},
          {"finger", draw.finger},
          {"edge_deg", draw.edge_deg},
          {"detected", draw.detected},
          {"status", static_cast<int>(draw.location.status)},
          {"error_m", {draw.error.x(), draw.error.y(), draw.error.z()}},
          {"sigma_m", {sigma.x(), sigma.y(), sigma.z()}},
          {"mahalanobis_2", draw.mahalanobis_2}};
}

void print(const char* name, const Consistency& result) {
  std::printf("%-22s %5d %8d %7d  %7.1f%% %6.2f  %7.3f %7.3f  %7.3f %7.3f  %s\n", name, result.drawn, result.detected,
              result.located, 100.0 * result.within, result.mean_nees, 1e3 * result.median_sigma,
              1e3 * result.median_worst_sigma, 1e3 * result.median_error, 1e3 * result.p95_error,
              holds(result) ? "met" : "missed");
}

bool experiment(const ExperimentOptions& options) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  ProgressBar progress(2 * options.trials);
  const auto draws = [&](Hiding hiding, const char* note) {
    return scenes::draw_hidden_marks(robot, hiding, options.trials, static_cast<unsigned>(options.seed), {},
                                     [&] { progress.advance(note); });
  };
  const std::vector<HiddenMarkDraw> whole = draws(Hiding::kNothing, "in full view");
  const std::vector<HiddenMarkDraw> hidden = draws(Hiding::kPartly, "partly hidden");
  std::vector<HiddenMarkDraw> half;
  constexpr double kAboutHalf = 0.35;
  for (const HiddenMarkDraw& draw : hidden) {
    if (std::max(draw.hidden_left, draw.hidden_right) >= kAboutHalf) half.push_back(draw);
  }
  std::printf(
      "\nbar: squared Mahalanobis distance to the true centre below 11.34 (chance: 99%%) in 98%%, its mean (NEES) 2 to "
      "4.5,\n"
      "median sigma at most 1.5 mm; of 1,000 draws, fewer scatter\n");
  const Consistency of_whole = scenes::consistency_of(whole);
  const Consistency of_hidden = scenes::consistency_of(hidden);
  const Consistency of_half = scenes::consistency_of(half);

  std::printf("\n%-22s %5s %8s %7s  %8s %6s  %15s  %15s\n%-22s %5s %8s %7s  %8s %6s  %7s %7s  %7s %7s\n", "", "drawn",
              "detected", "located", "within", "mean", "median sigma,mm", "error, mm", "", "", "", "", "11.34", "NEES",
              "mean", "worst", "median", "p95");
  print("in full view", of_whole);
  print("hidden, 5 to 50%", of_hidden);
  print("of these 35 to 50%", of_half);

  nlohmann::ordered_json json{
      {"whole", to_json(of_whole)}, {"hidden", to_json(of_hidden)}, {"half_hidden", to_json(of_half)}};
  for (const HiddenMarkDraw& draw : whole) json["whole_draws"].push_back(to_json(draw));
  for (const HiddenMarkDraw& draw : hidden) json["hidden_draws"].push_back(to_json(draw));
  std::ofstream(std::filesystem::path(options.out) / "hidden.json") << json.dump(1) << "\n";
  return holds(of_whole) && holds(of_hidden);
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  constexpr int kTrials = 1000;
  return markservo::experiments::run_experiment("Marks in full view and partly hidden, and what their covariance says",
                                                kTrials, argc, argv, markservo::experiments::experiment);
}
