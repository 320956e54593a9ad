// scripts/experiment learn: is a colour that is learned from one box the mark's, and is it told when it is not?

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "services/mark-detector/colour/hue.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/statistics.hpp"
#include "tests/scenes/learning_draws.hpp"

namespace markservo::experiments {
namespace {

using scenes::LearningDraw;

constexpr double kGoodOverlap = 0.8;  // intersection over union
constexpr double kLeastGood = 0.95;   // share of the draws
constexpr double kPoorOverlap = 0.5;  // below it there must be a warning, or nothing was learned

struct Totals {
  int drawn = 0;
  int good = 0;
  int failed = 0;  // nothing was learned, with the reason
  int warned = 0;
  int poor = 0;
  int poor_untold = 0;
  std::vector<double> overlaps;

  bool met() const { return good >= kLeastGood * drawn && poor_untold == 0; }
};

Totals totals_of(const std::vector<LearningDraw>& draws) {
  Totals totals;
  for (const LearningDraw& draw : draws) {
    const bool failed = !draw.failure.empty();
    const bool poor = draw.overlap < kPoorOverlap;
    ++totals.drawn;
    totals.good += draw.overlap >= kGoodOverlap ? 1 : 0;
    totals.failed += failed ? 1 : 0;
    totals.warned += draw.warning.empty() ? 0 : 1;
    totals.poor += poor ? 1 : 0;
    totals.poor_untold += poor && !failed && draw.warning.empty() ? 1 : 0;
    totals.overlaps.push_back(draw.overlap);
  }
  return totals;
}

nlohmann::ordered_json json_of(const LearningDraw& draw) {
  const mark_detector::Hsv body = mark_detector::hsv_of(draw.ball.body);
  const mark_detector::Hsv wall = mark_detector::hsv_of(draw.ball.wall);
  const robot::ColourInterval& c = draw.learned;
  nlohmann::ordered_json json{
      {"seed", draw.seed},
      {"radius_px", draw.ball.radius},
      {"body", {{"hue_deg", body.hue_deg}, {"saturation", body.saturation}, {"value", body.value / 255.0}}},
      {"wall", {{"hue_deg", wall.hue_deg}, {"saturation", wall.saturation}, {"value", wall.value / 255.0}}},
      {"highlight_share", draw.ball.highlight_share},
      {"highlight_peak", draw.ball.highlight_peak},
      {"ambient", draw.ball.ambient},
      {"box", {draw.box.x, draw.box.y, draw.box.width, draw.box.height}},
      {"shift_px", {draw.shift.x, draw.shift.y}},
      {"overlap", draw.overlap}};
  if (draw.failure.empty()) {
    json["learned"] = {{"hue_deg", {c.hue_min_deg, c.hue_max_deg}},
                       {"saturation", {c.saturation_min, c.saturation_max}},
                       {"value", {c.value_min, c.value_max}}};
  }
  json["failure"] = draw.failure;
  json["warning"] = draw.warning;
  return json;
}

nlohmann::ordered_json json_of(const Totals& totals) {
  return {{"drawn", totals.drawn},
          {"overlap_0.8_or_more", totals.good},
          {"overlap_below_0.5", totals.poor},
          {"overlap_below_0.5_untold", totals.poor_untold},
          {"refused", totals.failed},
          {"warned", totals.warned},
          {"median_overlap", median(totals.overlaps)},
          {"p5_overlap", percentile(totals.overlaps, 0.05)},
          {"least_overlap", percentile(totals.overlaps, 0.0)},
          {"met", totals.met()}};
}

bool experiment(const ExperimentOptions& options) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  ProgressBar progress(options.trials);
  const std::vector<LearningDraw> draws =
      scenes::draw_learning(robot.marks, 0, options.trials, static_cast<unsigned>(options.seed),
                            [&progress] { progress.advance("learned from a glossy ball"); });
  const Totals totals = totals_of(draws);
  std::printf("%6s %12s %12s %8s %7s %7s %14s\n", "drawn", "0.8 or more", "below 0.5", "untold", "refused", "warned",
              "median overlap");
  std::printf("%6d %12d %12d %8d %7d %7d %14.3f  %s\n", totals.drawn, totals.good, totals.poor, totals.poor_untold,
              totals.failed, totals.warned, median(totals.overlaps), totals.met() ? "met" : "missed");
  std::printf(
      "bar: what is found overlaps the ball by 0.8 or more (intersection over union) in 95%%, and never by less "
      "than 0.5\nwithout a warning or a refusal\n");
  nlohmann::ordered_json json{{"trials", options.trials}, {"seed", options.seed}, {"totals", json_of(totals)}};
  json["draws"] = nlohmann::ordered_json::array();
  for (const LearningDraw& draw : draws) json["draws"].push_back(json_of(draw));
  std::ofstream(std::filesystem::path(options.out) / "learn.json") << json.dump(1) << "\n";
  return totals.met();
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  constexpr int kTrials = 100;
  return markservo::experiments::run_experiment("Colours learned from glossy balls before walls of near hue", kTrials,
                                                argc, argv, markservo::experiments::experiment);
}
