// scripts/experiment plain: marks of one colour, squares, discs and balls, through the real detector and locator: how
// near their 3D error comes to the least that there can be, and whether the published covariance is true.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "tests/experiments/experiment.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/scenes/plain_draws.hpp"

namespace markservo::experiments {
namespace {

using scenes::PlainCase;
using scenes::PlainDraw;
using scenes::PlainForm;
using scenes::PlainTotals;

// What every case must keep, none being missed.
constexpr double kMostRatioOfSquares = 1.3;  // rms of the error over the Cramer-Rao bound's
constexpr double kMostRatioOfRound = 1.5;
constexpr double kLeastNees = 2.0;  // mean, 3 degrees of freedom
constexpr double kMostNees = 4.5;

bool holds(const PlainCase& what, const PlainTotals& totals) {
  const double most = what.form == PlainForm::kSquare ? kMostRatioOfSquares : kMostRatioOfRound;
  return totals.missed == 0 && totals.ratio() <= most && totals.mean_nees >= kLeastNees &&
         totals.mean_nees <= kMostNees;
}

nlohmann::ordered_json to_json(const PlainCase& what, const PlainTotals& totals) {
  return {{"case", what.name()},         {"drawn", totals.drawn},
          {"missed", totals.missed},     {"located_by_another_cue", totals.not_by_outline},
          {"rms_m", totals.rms},         {"cramer_rao_rms_m", totals.least_rms},
          {"ratio", totals.ratio()},     {"mean_nees", totals.mean_nees},
          {"holds", holds(what, totals)}};
}

nlohmann::ordered_json to_json(const PlainCase& what, const PlainDraw& draw) {
  const Eigen::Vector3d sigma = draw.location.covariance.diagonal().cwiseSqrt();
  return {{"case", what.name()},
          {"seed", draw.seed},
          {"contrast", draw.contrast},
          {"blur_px", draw.blur_px},
          {"detected", draw.detected},
          {"status", static_cast<int>(draw.location.status)},
          {"cue", static_cast<int>(draw.location.cue)},
          {"error_m", {draw.error.x(), draw.error.y(), draw.error.z()}},
          {"sigma_m", {sigma.x(), sigma.y(), sigma.z()}},
          {"cramer_rao_rms_m", draw.least_rms},
          {"nees", draw.nees}};
}

// Contrast 100, facing the cameras, lens and pixel together blurring by 0.6 px.
nlohmann::ordered_json check_of_the_bound() {
  nlohmann::ordered_json json;
  std::printf("Cramer-Rao bound of the disparity, contrast 100, blur 0.6 px in all:");
  for (const double width_px : {30.0, 60.0, 100.0}) {
    scenes::PlainMark mark;
    const geometry::StereoCamera camera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
    mark.size = 0.025;
    mark.p_C = scenes::point_at(camera, 400.3, 240.6, camera.fx * mark.size / width_px);
    mark.around = {60.0, 60.0, 60.0};
    mark.colour = {60.0, 60.0, 160.0};
    mark.blur_px = scenes::lens_blur(0.6);
    constexpr double kSigma = 3.0;
    const double sigma = scenes::least_disparity_sigma(mark, camera, kSigma);
    std::printf("  %.0f px: %.4f px", width_px, sigma);
    json.push_back({{"width_px", width_px}, {"disparity_sigma_px", sigma}});
  }
  std::printf("\n");
  return json;
}

bool experiment(const ExperimentOptions& options) {
  nlohmann::ordered_json json{{"check_of_the_bound", check_of_the_bound()}};
  const std::vector<PlainCase> cases = scenes::plain_cases();
  ProgressBar progress(static_cast<int>(cases.size()) * options.trials);
  bool all_hold = true;
  std::printf("bar: none missed, rms at most %.1f (squares) or %.1f times the bound, mean NEES %.1f to %.1f\n",
              kMostRatioOfSquares, kMostRatioOfRound, kLeastNees, kMostNees);
  std::printf("%-26s %5s %6s  %8s %8s %6s  %6s\n", "", "drawn", "missed", "rms, mm", "bound", "ratio", "NEES");
  for (const PlainCase& what : cases) {
    const std::vector<PlainDraw> draws = scenes::draw_plain_marks(
        what, options.trials, static_cast<unsigned>(options.seed), {}, [&] { progress.advance(what.name()); });
    const PlainTotals totals = scenes::totals_of(draws);
    all_hold = holds(what, totals) && all_hold;
    std::printf("%-26s %5d %6d  %8.4f %8.4f %6.2f  %6.2f  %s\n", what.name().c_str(), totals.drawn, totals.missed,
                1e3 * totals.rms, 1e3 * totals.least_rms, totals.ratio(), totals.mean_nees,
                holds(what, totals) ? "met" : "missed");
    json["totals"].push_back(to_json(what, totals));
    for (const PlainDraw& draw : draws) json["draws"].push_back(to_json(what, draw));
  }
  std::ofstream(std::filesystem::path(options.out) / "plain.json") << json.dump(1) << "\n";
  return all_hold;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  constexpr int kTrials = 200;
  return markservo::experiments::run_experiment(
      "3D error of marks of one colour beside the least that there can be, and their covariance", kTrials, argc, argv,
      markservo::experiments::experiment);
}
