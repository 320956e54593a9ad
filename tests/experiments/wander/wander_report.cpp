#include "tests/experiments/wander/wander_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/geometry/plane_pose.hpp"
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

// Those that there are, of a case's runs.
std::vector<double> values(const std::vector<WanderResult>& results, WanderCase the_case,
                           const std::function<std::optional<double>(const WanderResult&)>& value) {
  std::vector<double> list;
  for (const WanderResult& result : results) {
    if (result.the_case != the_case) continue;
    if (const std::optional<double> number = value(result)) list.push_back(*number);
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
  return static_cast<double>(result.score.lost.size());
}

std::optional<double> proposed_drift(const WanderResult& result) {
  return proposal_of(result).drift_deg_per_sqrt_m;
}

std::optional<double> proposed_wander(const WanderResult& result) {
  return proposal_of(result).pivot_wander;
}

// deg per sqrt(m)
std::optional<double> fitting_drift(const WanderResult& result) {
  if (!result.score.wheels) return std::nullopt;
  return geometry::degrees(result.score.wheels->drift.fits);
}

std::optional<double> fitting_wander(const WanderResult& result) {
  if (!result.score.wheels) return std::nullopt;
  return result.score.wheels->pivot_wander.fits;
}

// As a share of the true one. What is not told is all of it off.
double off(const std::optional<double>& proposed, double truth) {
  return proposed ? std::abs(*proposed / truth - 1.0) : 1.0;
}

double mean_error(const std::vector<WanderResult>& results, WanderCase the_case) {
  return mean(values(results, the_case, error_of));
}

double ratio(const std::vector<WanderResult>& results, WanderCase the_case) {
  return mean_error(results, the_case) / mean(values(results, the_case, bound_of));
}

Json json_of(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json json_of(const WanderResult& result) {
  const WanderScore& score = result.score;
  Json lost = Json::array();
  for (const LostSpell& spell : score.lost) {
    lost.push_back({{"at_s", spell.begin}, {"for_s", spell.duration}, {"reason", spell.reason}});
  }
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
          {"lost", lost},
          {"fits_drift_deg_per_sqrt_m", json_of(fitting_drift(result))},
          {"fits_pivot_wander", json_of(fitting_wander(result))},
          {"proposed_drift_deg_per_sqrt_m", json_of(proposed_drift(result))},
          {"proposed_pivot_wander", json_of(proposed_wander(result))},
          {"says", score.wheels ? Json(rfid_localizer::describe(*score.wheels)) : Json(nullptr)}};
}

Json totals_of(const std::vector<WanderResult>& results, WanderCase the_case) {
  const auto spread = [&](auto number) {
    const std::vector<double> list = values(results, the_case, number);
    if (list.empty()) return Json(nullptr);
    return Json{{"runs", list.size()}, {"mean", mean(list)}, {"min", percentile(list, 0.0)}, {"max", maximum(list)}};
  };
  return {{"case", name_of(the_case)},
          {"runs", values(results, the_case, error_of).size()},
          {"mean_error_m", mean_error(results, the_case)},
          {"bound_m", mean(values(results, the_case, bound_of))},
          {"ratio", ratio(results, the_case)},
          {"nees", mean(values(results, the_case, nees_of))},
          {"nees_max", maximum(values(results, the_case, nees_of))},
          {"lost_max", maximum(values(results, the_case, lost_of))},
          {"fits_drift_deg_per_sqrt_m", spread(fitting_drift)},
          {"fits_pivot_wander", spread(fitting_wander)},
          {"proposed_drift_deg_per_sqrt_m", spread(proposed_drift)},
          {"proposed_pivot_wander", spread(proposed_wander)}};
}

// How far a proposed number goes over the runs, and how many propose one.
std::string range(const std::vector<double>& proposed, double factor) {
  if (proposed.empty()) return "-";
  return fmt::format("{:.2g} to {:.2g} ({})", factor * percentile(proposed, 0.0), factor * maximum(proposed),
                     proposed.size());
}

void print_lost(const std::vector<WanderResult>& results) {
  for (const WanderResult& result : results) {
    for (const LostSpell& spell : result.score.lost) {
      std::printf("LOST: %s, seed %lld, at %.1f s for %.1f s: %s\n", name_of(result.the_case),
                  static_cast<long long>(result.seed), spell.begin, spell.duration, spell.reason.c_str());
    }
  }
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

rfid_localizer::WheelProposal proposal_of(const WanderResult& result) {
  if (!result.score.wheels) return {};
  return rfid_localizer::proposal(*result.score.wheels);
}

std::vector<Verdict> wander_verdicts(const std::vector<WanderResult>& results,
                                     const simulator::BaseModelParameters& truth) {
  double drift_off = 0.0;
  double wander_off = 0.0;
  for (const WanderResult& result : results) {
    if (result.the_case != WanderCase::kDelivered) continue;
    drift_off = std::max(drift_off, off(proposed_drift(result), geometry::degrees(truth.drift)));
    wander_off = std::max(wander_off, off(proposed_wander(result), truth.pivot_wander));
  }
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
              "LOST", "proposed (runs): drift, deg/sqrt(m); wander, cm/sqrt(rad)");
  for (const WanderCase the_case : kCases) {
    std::printf("%-22s %4zu  %5.2f / %5.2f      %5.2f %6.2f %5.2f %7.0f  %s; %s\n", name_of(the_case),
                values(results, the_case, error_of).size(), 100.0 * mean_error(results, the_case),
                100.0 * mean(values(results, the_case, bound_of)), ratio(results, the_case),
                mean(values(results, the_case, nees_of)), maximum(values(results, the_case, nees_of)),
                maximum(values(results, the_case, lost_of)),
                range(values(results, the_case, proposed_drift), 1.0).c_str(),
                range(values(results, the_case, proposed_wander), 100.0).c_str());
  }
  print_lost(results);
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
