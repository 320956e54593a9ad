#include "tests/experiments/localisation/case_result.hpp"

#include <cmath>

#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

const Eigen::Vector2d& chosen(const PaperError& error, PaperValue value) {
  if (value == PaperValue::kMeasured) return error.measured;
  return value == PaperValue::kCompensated ? error.compensated : error.fused;
}

}  // namespace

void LiveTotals::add(const BoundedScore& score) {
  append(all, score.live.all);
  append(settled, score.live.settled);
  append(bound_all, score.bound_all);
  append(bound_settled, score.bound_settled);
  append(heading, score.live.settled_heading);
  append(bound_heading, score.bound_heading);
  append(nees, score.live.settled_nees);
  not_localised += score.live.settled_not_localised;
  without_pose += score.live.without_pose;
  diverged += score.live.diverged ? 1 : 0;
}

double LiveTotals::not_localised_share() const {
  return settled.empty() ? NAN : not_localised / static_cast<double>(settled.size());
}

double LiveTotals::bound_ratio() const {
  return mean(settled) / mean(bound_settled);
}

void CaseResult::add(const TrialResult& trial) {
  if (trials == 0) picture = trial.picture;
  ++trials;
  with_encoders.add(trial.with_encoders);
  if (trial.without_encoders) {
    if (!free_sampled) free_sampled.emplace();
    if (!free_published) free_published.emplace();
    free_sampled->add(trial.without_encoders->sampled);
    free_published->add(trial.without_encoders->published);
  }
  if (trial.with_encoders.live.diverged) diverged_seeds.push_back(trial.seed);
  paper.insert(paper.end(), trial.paper.begin(), trial.paper.end());
  delay_errors.push_back(std::abs(trial.delay_error));
  delay_bound += (trial.delay_error_bound - delay_bound) / trials;
}

std::vector<double> components(const std::vector<PaperError>& errors, PaperValue value, Axis axis, int first_read) {
  std::vector<double> result;
  for (const PaperError& error : errors) {
    if (error.read < first_read) continue;
    const Eigen::Vector2d& e = chosen(error, value);
    result.push_back(axis == Axis::kX ? e.x() : axis == Axis::kY ? e.y() : e.dot(error.along));
  }
  return result;
}

std::vector<Axis> table_axes(const LocalisationCase& the_case) {
  if (the_case.course == "straight") return {Axis::kY};
  return {Axis::kX, Axis::kY};
}

double compensation_gain(const std::vector<PaperError>& errors, Axis axis, int first_read) {
  const double measured = absolute_spread(components(errors, PaperValue::kMeasured, axis, first_read)).mean;
  const double compensated = absolute_spread(components(errors, PaperValue::kCompensated, axis, first_read)).mean;
  return 1.0 - compensated / measured;
}

}  // namespace markservo::experiments
