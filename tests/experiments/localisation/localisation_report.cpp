#include "tests/experiments/localisation/localisation_report.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "common/geometry/plane_pose.hpp"
#include "tests/experiments/localisation/localisation_bars.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kCentimetres = 100.0;

// Average, maximum, minimum, cm (paper, table 2).
struct PaperRow {
  const char* course;
  Axis axis;
  std::array<double, 3> measured;
  std::array<double, 3> compensated;
};
constexpr std::array<PaperRow, 3> kPaperTable{{{"straight", Axis::kY, {7.5, 11.7, 1.3}, {2.5, 6.6, 0.2}},
                                               {"diagonal", Axis::kX, {5.2, 9.5, 0.3}, {1.8, 4.5, 0.1}},
                                               {"diagonal", Axis::kY, {5.7, 10.4, 0.7}, {2.4, 5.4, 0.1}}}};

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json json_of(const Spread& spread) {
  return {{"mean_m", number(spread.mean)}, {"max_m", number(spread.max)}, {"min_m", number(spread.min)}};
}

// The axes of the paper's table pooled, and each.
Json paper_json(const CaseResult& result, PaperValue value) {
  std::vector<double> pooled;
  Json each = Json::object();
  for (const Axis axis : table_axes(result.the_case)) {
    const auto values = components(result.paper, value, axis, kSettledRead);
    pooled.insert(pooled.end(), values.begin(), values.end());
    each[axis == Axis::kX ? "x" : "y"] = json_of(absolute_spread(values));
    each[axis == Axis::kX ? "x_all_reads" : "y_all_reads"] =
        json_of(absolute_spread(components(result.paper, value, axis, 1)));
  }
  Json json = json_of(absolute_spread(pooled));
  json["along"] = json_of(absolute_spread(components(result.paper, value, Axis::kAlong, kSettledRead)));
  json.update(each);
  return json;
}

Json live_json(const LiveTotals& totals) {
  Json json = json_of(absolute_spread(totals.settled));
  json["p99_m"] = number(percentile(totals.settled, 0.99));
  json["bound_m"] = number(mean(totals.bound_settled));
  json["ratio"] = number(totals.bound_ratio());
  json["all_mean_m"] = number(mean(totals.all));
  json["all_bound_m"] = number(mean(totals.bound_all));
  json["heading_mean_rad"] = number(mean(totals.heading));
  json["heading_bound_rad"] = number(mean(totals.bound_heading));
  json["nees"] = number(mean(totals.nees));
  json["not_localised_share"] = number(totals.not_localised_share());
  json["diverged"] = totals.diverged;
  return json;
}

std::string group(const Spread& spread) {
  char text[64];
  std::snprintf(text, sizeof text, "%5.2f /%6.2f /%5.2f", kCentimetres * spread.mean, kCentimetres * spread.max,
                kCentimetres * spread.min);
  return text;
}

std::string group(const std::array<double, 3>& values) {
  char text[64];
  std::snprintf(text, sizeof text, "%5.1f /%6.1f /%5.1f", values[0], values[1], values[2]);
  return text;
}

void print_without_encoders(const std::vector<CaseResult>& results) {
  bool titled = false;
  for (const CaseResult& result : results) {
    if (!result.free_sampled) continue;
    if (!titled) {
      std::printf(
          "\nWithout encoders, cm: ours / bound of steady motion\n%-21s  %-31s  %-31s\n%-21s  %-15s %-15s  %s\n", "",
          "sent once a round", "moved on to 50 Hz", "case", "settled", "all", "settled         all");
      titled = true;
    }
    std::printf("%-21s", result.the_case.name.c_str());
    for (const LiveTotals* totals : {&*result.free_published, &*result.free_sampled}) {
      std::printf("  %5.2f / %5.2f   %5.2f / %5.2f ", kCentimetres * mean(totals->settled),
                  kCentimetres * mean(totals->bound_settled), kCentimetres * mean(totals->all),
                  kCentimetres * mean(totals->bound_all));
    }
    std::printf("\n");
  }
}

}  // namespace

void print_cases(const std::vector<CaseResult>& results) {
  std::printf(
      "\nRadial error of the live pose, mean, cm: ours / Fisher bound. Settled: 1 s after the first read, static 5 s; "
      "all: from the first read on.\n%-21s %4s  %-19s %5s  %-13s  %-12s %5s %6s %4s\n",
      "case", "runs", "settled: ratio", "p99", "all", "heading, deg", "NEES", "unsure", "div.");
  for (const CaseResult& result : results) {
    const LiveTotals& ours = result.with_encoders;
    std::printf("%-21s %4d  %5.2f / %5.2f: %4.2f %5.2f  %5.2f / %5.2f  ", result.the_case.name.c_str(), result.trials,
                kCentimetres * mean(ours.settled), kCentimetres * mean(ours.bound_settled), ours.bound_ratio(),
                kCentimetres * percentile(ours.settled, 0.99), kCentimetres * mean(ours.all),
                kCentimetres * mean(ours.bound_all));
    if (ours.heading.empty()) {
      std::printf("%-12s ", "     -");
    } else {
      std::printf("%5.2f / %4.2f ", geometry::degrees(mean(ours.heading)), geometry::degrees(mean(ours.bound_heading)));
    }
    std::printf("%5.2f %5.1f%% %4d%s\n", mean(ours.nees), 100.0 * ours.not_localised_share(), ours.diverged,
                result.the_case.bars.none() ? "  reported only" : "");
  }
  std::printf("unsure: samples not LOCALISED; div.: runs with %d samples in a row above %.0f cm, settled\n",
              LiveScoreParameters{}.diverged_samples, kCentimetres * LiveScoreParameters{}.diverged_error);
  print_without_encoders(results);
  for (const CaseResult& result : results) {
    if (!result.diverged_seeds.empty()) {
      std::printf("%s diverged with seeds", result.the_case.name.c_str());
      for (const std::int64_t seed : result.diverged_seeds) std::printf(" %lld", static_cast<long long>(seed));
      std::printf("\n");
    }
    if (!result.the_case.delay_sigma) continue;
    std::printf(
        "%s: error of the delay at the end %.1f ms mean, %.1f ms at most; bound on its standard deviation %.1f ms\n",
        result.the_case.name.c_str(), 1e3 * mean(result.delay_errors), 1e3 * maximum(result.delay_errors),
        1e3 * result.delay_bound);
  }
}

void print_paper_table(const std::vector<CaseResult>& results) {
  bool titled = false;
  for (const PaperRow& row : kPaperTable) {
    for (const CaseResult& result : results) {
      if (result.the_case.name != row.course) continue;
      if (!titled) {
        std::printf(
            "\nThe paper's table 2: error at the reads, cm, average / maximum / minimum; simulated from the 4th read "
            "on\n%-9s %4s  %-12s %-21s  %-21s  %-21s %s\n",
            "course", "axis", "", "measured", "compensated", "ours (fused)", "gain of compensation");
        titled = true;
      }
      const auto simulated = [&](PaperValue value, int first_read) {
        return group(absolute_spread(components(result.paper, value, row.axis, first_read)));
      };
      const char* axis = row.axis == Axis::kX ? "x" : "y";
      std::printf("%-9s %4s  %-12s %s  %s  %-21s %4.0f%%\n", row.course, axis, "the paper's",
                  group(row.measured).c_str(), group(row.compensated).c_str(), "",
                  100.0 * (1.0 - row.compensated[0] / row.measured[0]));
      for (const int first_read : {kSettledRead, 1}) {
        std::printf("%-9s %4s  %-12s %s  %s  %s %4.0f%%\n", "", "", first_read == 1 ? "all reads" : "simulated",
                    simulated(PaperValue::kMeasured, first_read).c_str(),
                    simulated(PaperValue::kCompensated, first_read).c_str(),
                    simulated(PaperValue::kFused, first_read).c_str(),
                    100.0 * compensation_gain(result.paper, row.axis, first_read));
      }
    }
  }
}

bool print_verdicts(const std::vector<CaseResult>& results, std::optional<double> hall_mean) {
  bool all_met = true;
  int met = 0;
  int asked = 0;
  std::printf("\n");
  for (const CaseResult& result : results) {
    if (result.the_case.bars.none()) std::printf("-       %-21s reported only\n", result.the_case.name.c_str());
    for (const Verdict& verdict : verdicts(result, hall_mean)) {
      ++asked;
      met += verdict.met() ? 1 : 0;
      all_met = all_met && verdict.met();
      print_verdict(verdict, result.the_case.name);
    }
  }
  std::printf("%d of %d bars met\n", met, asked);
  return all_met;
}

void write_localisation_json(const std::vector<CaseResult>& results, const std::string& folder) {
  Json runs = Json::array();
  for (const CaseResult& result : results) {
    const LiveTotals& ours = result.with_encoders;
    runs.push_back(
        {{"case", result.the_case.name},
         {"course", result.the_case.course},
         {"variant", result.the_case.variant},
         {"trials", result.trials},
         {"measured", paper_json(result, PaperValue::kMeasured)},
         {"compensated", paper_json(result, PaperValue::kCompensated)},
         {"fused_at_reads", paper_json(result, PaperValue::kFused)},
         {"fused", live_json(ours)},
         {"fused_without_encoders", result.free_published ? live_json(*result.free_published) : Json(nullptr)},
         {"fused_without_encoders_at_50_Hz", result.free_sampled ? live_json(*result.free_sampled) : Json(nullptr)},
         {"heading_mean_rad", number(mean(ours.heading))},
         {"nees", number(mean(ours.nees))},
         {"delay_error_s", number(mean(result.delay_errors))},
         {"delay_error_max_s", number(maximum(result.delay_errors))},
         {"delay_bound_s", number(result.delay_bound)},
         {"diverged", ours.diverged}});
  }
  std::ofstream(std::filesystem::path(folder) / "localisation.json") << Json{{"runs", runs}}.dump(2) << "\n";
}

}  // namespace markservo::experiments
