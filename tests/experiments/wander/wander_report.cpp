#include "tests/experiments/wander/wander_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/geometry/plane_pose.hpp"
#include "services/rfid-localizer/wheel_report.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

using Json = nlohmann::ordered_json;

constexpr WanderCase kCases[] = {WanderCase::kDelivered, WanderCase::kProposed, WanderCase::kStated,
                                 WanderCase::kStatedUnjudged};
constexpr double kNone = -std::numeric_limits<double>::infinity();

// A covariance that is right scores 3; a mixture is not one Gaussian.
constexpr double kLeastNees = 2.0;
constexpr double kMostNees = 4.5;
constexpr double kMostLost = 1.0;
constexpr double kMostRatio = 1.1;
constexpr double kMostOff = 0.3;      // of a proposed number, as a share of the true one
constexpr double kMostChange = 0.03;  // of the error, with wheels as stated

std::vector<double> values(const std::vector<WanderResult>& results, WanderCase the_case,
                           const std::function<double(const WanderResult&)>& value) {
  std::vector<double> list;
  for (const WanderResult& result : results) {
    if (result.the_case == the_case) list.push_back(value(result));
  }
  return list;
}

double error_of(const WanderResult& result) {
  return result.score.error;
}

double bound_of(const WanderResult& result) {
  return result.bound;
}

double nees_of(const WanderResult& result) {
  return result.score.nees;
}

double lost_of(const WanderResult& result) {
  return result.score.lost;
}

double mean_error(const std::vector<WanderResult>& results, WanderCase the_case) {
  return mean(values(results, the_case, error_of));
}

double ratio(const std::vector<WanderResult>& results, WanderCase the_case) {
  return mean_error(results, the_case) / mean(values(results, the_case, bound_of));
}

Json json_of(const WanderResult& result) {
  const WanderScore& score = result.score;
  return {{"case", name_of(result.the_case)},
          {"seed", result.seed},
          {"driven_m", result.driven},
          {"turned_rad", result.turned},
          {"mean_error_m", score.error},
          {"bound_m", result.bound},
          {"ratio", score.error / result.bound},
          {"heading_error_rad", score.heading_error},
          {"nees", score.nees},
          {"not_localised_share", score.not_localised},
          {"lost", score.lost},
          {"fits_drift_deg_per_sqrt_m", geometry::degrees(score.wheels.drift.fits)},
          {"fits_pivot_wander", score.wheels.pivot_wander.fits},
          {"says", rfid_localizer::describe(score.wheels)}};
}

Json totals_of(const std::vector<WanderResult>& results, WanderCase the_case) {
  const auto fits = [&](auto number) {
    const std::vector<double> list = values(results, the_case, number);
    return Json{{"mean", mean(list)}, {"min", percentile(list, 0.0)}, {"max", maximum(list)}};
  };
  return {
      {"case", name_of(the_case)},
      {"runs", values(results, the_case, error_of).size()},
      {"mean_error_m", mean_error(results, the_case)},
      {"bound_m", mean(values(results, the_case, bound_of))},
      {"ratio", ratio(results, the_case)},
      {"nees", mean(values(results, the_case, nees_of))},
      {"nees_max", maximum(values(results, the_case, nees_of))},
      {"lost_max", maximum(values(results, the_case, lost_of))},
      {"fits_drift_deg_per_sqrt_m",
       fits([](const WanderResult& result) { return geometry::degrees(result.score.wheels.drift.fits); })},
      {"fits_pivot_wander", fits([](const WanderResult& result) { return result.score.wheels.pivot_wander.fits; })}};
}

}  // namespace

const char* name_of(WanderCase the_case) {
  switch (the_case) {
    case WanderCase::kDelivered:
      return "worse, as delivered";
    case WanderCase::kProposed:
      return "worse, as proposed";
    case WanderCase::kStated:
      return "as stated";
    case WanderCase::kStatedUnjudged:
      return "as stated, not judged";
  }
  return "";
}

std::vector<Verdict> wander_verdicts(const std::vector<WanderResult>& results,
                                     const simulator::BaseModelParameters& truth) {
  const auto off = [&](double true_value, auto number) {
    double worst = 0.0;
    for (const double fits : values(results, WanderCase::kDelivered, number)) {
      worst = std::max(worst, std::abs(fits / true_value - 1.0));
    }
    return worst;
  };
  const double drift_off = off(truth.drift, [](const WanderResult& result) { return result.score.wheels.drift.fits; });
  const double wander_off =
      off(truth.pivot_wander, [](const WanderResult& result) { return result.score.wheels.pivot_wander.fits; });
  const double change = mean_error(results, WanderCase::kStated) / mean_error(results, WanderCase::kStatedUnjudged) - 1;
  return {
      {"worse wheels, robot.yaml as delivered: NEES, 3 degrees of freedom",
       mean(values(results, WanderCase::kDelivered, nees_of)), kLeastNees, kMostNees, ""},
      {"the same: times LOST in 15 minutes, worst run", maximum(values(results, WanderCase::kDelivered, lost_of)),
       kNone, kMostLost, ""},
      {"worse wheels, robot.yaml as proposed: error over the bound", ratio(results, WanderCase::kProposed), kNone,
       kMostRatio, ""},
      {"proposed drift off the true one, worst run", 100.0 * drift_off, kNone, 100.0 * kMostOff, "%"},
      {"proposed wander off the true one, worst run", 100.0 * wander_off, kNone, 100.0 * kMostOff, "%"},
      {"wheels as stated: error changed by judging them", 100.0 * std::abs(change), kNone, 100.0 * kMostChange, "%"}};
}

void print_wander(const std::vector<WanderResult>& results) {
  std::printf("\n%-22s %4s  %-18s %5s %6s %5s %7s  %s\n", "case", "runs", "error / bound, cm", "ratio", "NEES", "worst",
              "LOST", "fits: drift, deg/sqrt(m); wander, cm/sqrt(rad)");
  for (const WanderCase the_case : kCases) {
    const auto drifts = values(results, the_case, [](const WanderResult& result) {
      return geometry::degrees(result.score.wheels.drift.fits);
    });
    const auto wanders = values(
        results, the_case, [](const WanderResult& result) { return 100.0 * result.score.wheels.pivot_wander.fits; });
    std::printf("%-22s %4zu  %5.2f / %5.2f      %5.2f %6.2f %5.2f %7.0f  %.2f to %.2f; %.2f to %.2f\n",
                name_of(the_case), drifts.size(), 100.0 * mean_error(results, the_case),
                100.0 * mean(values(results, the_case, bound_of)), ratio(results, the_case),
                mean(values(results, the_case, nees_of)), maximum(values(results, the_case, nees_of)),
                maximum(values(results, the_case, lost_of)), percentile(drifts, 0.0), maximum(drifts),
                percentile(wanders, 0.0), maximum(wanders));
  }
}

void write_wander_json(const std::vector<WanderResult>& results, const std::vector<Verdict>& verdicts,
                       const std::string& folder) {
  Json json{{"runs", Json::array()}, {"totals", Json::array()}, {"bars", Json::array()}};
  for (const WanderResult& result : results) json["runs"].push_back(json_of(result));
  for (const WanderCase the_case : kCases) json["totals"].push_back(totals_of(results, the_case));
  for (const Verdict& verdict : verdicts) {
    json["bars"].push_back({{"what", verdict.what},
                            {"value", verdict.value},
                            {"unit", verdict.unit},
                            {"least", std::isfinite(verdict.least) ? Json(verdict.least) : Json(nullptr)},
                            {"most", verdict.most},
                            {"met", verdict.met()}});
  }
  std::ofstream(std::filesystem::path(folder) / "wander.json") << json.dump(2) << "\n";
}

}  // namespace markservo::experiments
