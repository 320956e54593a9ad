#include "tests/experiments/localisation/localisation_bars.hpp"

#include <cmath>
#include <limits>

#include "common/geometry/plane_pose.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kCentimetres = 100.0;

// A covariance that is right scores 3; the run's samples are few and alike, and a mixture is not one Gaussian.
constexpr double kLeastNees = 2.0;
constexpr double kMostNees = 4.5;

// The paper's method on its own courses: late by 5 to 10 cm along the motion, at most 2.2 cm when compensated.
constexpr double kLeastMeasured_cm = 5.0;
constexpr double kMostMeasured_cm = 10.0;
constexpr double kMostCompensated_cm = 2.2;

Verdict at_most(const std::string& what, double value, double most, const std::string& unit) {
  return {what, value, kNone, most, unit};
}

void add_paper(const CaseResult& result, std::vector<Verdict>& list) {
  const auto mean_error = [&result](PaperValue value, Axis axis) {
    return kCentimetres * absolute_spread(components(result.paper, value, axis, kSettledRead)).mean;
  };
  list.push_back({"the paper's measured error along the motion", mean_error(PaperValue::kMeasured, Axis::kAlong),
                  kLeastMeasured_cm, kMostMeasured_cm, "cm"});
  for (const Axis axis : table_axes(result.the_case)) {
    const std::string name = axis == Axis::kX ? "x" : "y";
    list.push_back(at_most("the paper's compensated error in " + name, mean_error(PaperValue::kCompensated, axis),
                           kMostCompensated_cm, "cm"));
    list.push_back({"gain by the paper's compensation in " + name,
                    100.0 * compensation_gain(result.paper, axis, kSettledRead),
                    100.0 * *result.the_case.bars.paper_gain_axis, kNoLimit, "%"});
  }
}

}  // namespace

std::vector<Verdict> verdicts(const CaseResult& result, std::optional<double> hall_mean) {
  const CaseBars& bars = result.the_case.bars;
  const LiveTotals& ours = result.with_encoders;
  std::vector<Verdict> list;
  const auto lengths = [&list](const std::string& what, const std::optional<double>& bar, double value) {
    if (bar) list.push_back(at_most(what, kCentimetres * value, kCentimetres * *bar, "cm"));
  };
  list.push_back(at_most("samples without a pose", ours.without_pose, 0.0, ""));
  lengths("mean error, settled", bars.settled_mean, mean(ours.settled));
  lengths("mean error, all", bars.all_mean, mean(ours.all));
  if (bars.free_mean) {
    lengths("mean error without encoders at 50 Hz", bars.free_mean,
            result.free_sampled ? mean(result.free_sampled->settled) : NAN);
  }
  if (bars.bound_ratio) list.push_back(at_most("ours over the bound", ours.bound_ratio(), *bars.bound_ratio, ""));
  if (bars.hall_ratio && hall_mean) {
    list.push_back(at_most("ours over the undisturbed hall", mean(ours.settled) / *hall_mean, *bars.hall_ratio, ""));
  }
  if (bars.heading_mean) {
    list.push_back(at_most("mean heading error", geometry::degrees(mean(ours.heading)),
                           geometry::degrees(*bars.heading_mean), "deg"));
  }
  if (bars.delay_error) {
    list.push_back(at_most("mean error of the delay", 1e3 * mean(result.delay_errors), 1e3 * *bars.delay_error, "ms"));
  }
  if (bars.not_localised_share) {
    list.push_back(
        at_most("samples not localised", 100.0 * ours.not_localised_share(), 100.0 * *bars.not_localised_share, "%"));
  }
  if (bars.nees) list.push_back({"NEES, 3 degrees of freedom", mean(ours.nees), kLeastNees, kMostNees, ""});
  if (bars.must_not_diverge) list.push_back(at_most("runs diverged", ours.diverged, 0.0, ""));
  if (bars.paper_gain_axis) add_paper(result, list);
  return list;
}

}  // namespace markservo::experiments
