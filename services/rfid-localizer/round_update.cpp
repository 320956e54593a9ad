#include "services/rfid-localizer/round_update.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {
namespace {

// No outcome ends a hypothesis for good in one round.
constexpr double kLeastEvidence = 1e-300;

const HeardTag* find(const std::vector<HeardTag>& heard, int tag) {
  const auto at = std::find_if(heard.begin(), heard.end(), [tag](const HeardTag& one) { return one.tag == tag; });
  return at == heard.end() ? nullptr : &*at;
}

std::vector<TagOutcome> outcomes_of(const std::vector<int>& near, const std::vector<HeardTag>& heard,
                                    const RoundTime& time, const Eigen::Vector2d& velocity, const Floor& floor) {
  std::vector<TagOutcome> outcomes;
  outcomes.reserve(near.size());
  for (const int tag : near) {
    TagOutcome outcome;
    outcome.p_W = floor.map.position(tag);
    outcome.reliability = floor.reliability.of(tag);
    if (const HeardTag* answer = find(heard, tag)) {
      outcome.read = true;
      outcome.moment_known = answer->moment.has_value();
      if (answer->moment) outcome.offset = seconds_between(time.middle, *answer->moment) * velocity;
    }
    outcomes.push_back(outcome);
  }
  return outcomes;
}

// The parts of the place that the round leaves, each with what is jointly Gaussian with the place.
void add_parts(const Hypothesis& one, const AntennaView& view, const Eigen::Matrix2d& S, const RoundMatch& found,
               bool learns_delay, double weight, Mixture& mixture) {
  const Eigen::Matrix<double, 5, 2> regression = one.covariance * view.H.transpose() * S.inverse();
  Eigen::Matrix<double, 5, 2> K = regression;
  if (!learns_delay) K.row(kDelay).setZero();
  for (const PlacePart& part : found.parts) {
    const Eigen::Matrix2d gain = S - part.covariance;
    const StateCovariance cross = K * gain * regression.transpose();
    Hypothesis next;
    next.mode = one.mode;
    next.weight = weight * part.share;
    next.mean = one.mean + K * (part.mean - view.p_WF);
    next.covariance = one.covariance - cross - cross.transpose() + K * gain * K.transpose();
    next.covariance = 0.5 * (next.covariance + next.covariance.transpose()).eval();
    mixture.push_back(next);
  }
}

TagTally& tally_of(int tag, const std::vector<HeardTag>& heard, std::vector<TagTally>& tallies) {
  const auto at = std::find_if(tallies.begin(), tallies.end(), [tag](const TagTally& one) { return one.tag == tag; });
  if (at != tallies.end()) return *at;
  tallies.push_back({tag, find(heard, tag) != nullptr, 0.0, 0.0});
  return tallies.back();
}

}  // namespace

AntennaView antenna_in_the_middle(const Hypothesis& hypothesis, std::int64_t utime, const Motion& motion,
                                  const RoundTime& time) {
  AntennaView view = motion.antenna(hypothesis, time.middle, time.length);
  if (!time.known) view.H.col(kDelay) = -view.velocity;
  const double earlier = time.known ? 0.0 : hypothesis.mean[kDelay] - time.delay;
  view.p_WF += (seconds_between(utime, time.middle) - earlier) * view.velocity;
  return view;
}

RoundUpdate update(const Belief& belief, const Motion& motion, const RoundTime& time,
                   const std::vector<HeardTag>& heard, const Floor& floor, const RoundMatchParameters& parameters) {
  const double round_s = seconds_between(0, time.length);
  RoundUpdate result;
  double before = 0.0;
  double after = 0.0;
  std::vector<int> near;
  for (const Hypothesis& one : belief.mixture) {
    const AntennaView view = antenna_in_the_middle(one, belief.utime, motion, time);
    const Eigen::Matrix2d S = view.H * one.covariance * view.H.transpose();
    const Eigen::Vector2d way = view.velocity * round_s;
    floor.map.near(view.p_WF, floor.model.reach() + parameters.span * larger_sigma(S) + way.norm(), near);
    const RoundMatch found = match_round(view.p_WF, S, outcomes_of(near, heard, time, view.velocity, floor),
                                         window_points(way), floor.model, parameters);
    // A read that this hypothesis cannot explain speaks against it.
    double unexplained = 1.0;
    for (const HeardTag& answer : heard) {
      if (!std::binary_search(near.begin(), near.end(), answer.tag)) unexplained *= parameters.false_read;
    }
    const double weight = one.weight * std::max(found.evidence * unexplained, kLeastEvidence);
    before += one.weight;
    after += weight;
    add_parts(one, view, S, found, motion.learns_delay(), weight, result.mixture);
    for (std::size_t k = 0; k < near.size(); ++k) {
      TagTally& tally = tally_of(near[k], heard, result.tags);
      tally.inside += weight * found.inside[k];
      tally.chance += one.weight * found.chance[k];
    }
  }
  for (TagTally& tally : result.tags) {
    tally.inside /= after;
    tally.chance /= before;
  }
  result.probability = after / before;
  return result;
}

}  // namespace markservo::rfid_localizer
