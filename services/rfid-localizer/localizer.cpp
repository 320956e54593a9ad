#include "services/rfid-localizer/localizer.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "services/rfid-localizer/surprise.hpp"

namespace markservo::rfid_localizer {
namespace {

constexpr double kSeconds = 1e-6;

double larger_sigma(const Eigen::Matrix2d& covariance) {
  return std::sqrt(std::max(0.0, covariance.eigenvalues().real().maxCoeff()));
}

// The map's own errors blur the footprint's edge. A logistic of scale s has the variance (pi s)^2 / 3.
double blurred(double softness, double survey_sigma) {
  return std::sqrt(softness * softness + 3.0 * survey_sigma * survey_sigma / (M_PI * M_PI));
}

[[noreturn]] void refuse_time(const char* what, std::int64_t utime, std::int64_t last) {
  throw std::invalid_argument(std::string(what) + ": utime " + std::to_string(utime) + " us is not after the last, " +
                              std::to_string(last) + "; allowed: growing times");
}

}  // namespace

Localizer::Localizer(const robot::BaseDescription& base, const robot::RfidDescription& rfid,
                     const robot::TagField& field, const LocalizerParameters& parameters)
    : rfid_(rfid),
      parameters_(parameters),
      map_(field, rfid.reading_radius),
      model_(rfid.reading_radius, blurred(rfid.edge_softness, parameters.survey_sigma)),
      reliability_(field.tags.size(), parameters.reliability),
      counters_(base),
      wheel_motion_(history_, rfid.p_RF, parameters.wheels),
      free_motion_(rfid.p_RF, parameters.free),
      motion_(&free_motion_),
      paper_(parameters.paper),
      trust_(parameters.trust) {
  wheel_motion_.set_heading(parameters.start_heading);
}

void Localizer::lose(const std::string& why) {
  mixture_.clear();
  trust_.lose(why);
  // What was known of the heading at the start is past.
  wheel_motion_.set_heading(std::nullopt);
}

void Localizer::observe(const EncoderReading& reading) {
  if (!history_.empty() && reading.utime <= history_.newest()) {
    if (reading.session == wheel_session_ && !late_odometry_.persists()) {
      ++faults_.late_odometry;
      refuse_time("WHEEL_ODOMETRY", reading.utime, history_.newest());
    }
    // Another driver, or a clock that was set back: all that was known belongs to another time.
    history_.clear();
    counters_.forget();
    last_round_.reset();
    paper_.restart();
    lose("WHEEL_ODOMETRY began anew at an earlier time");
  }
  if (!mixture_.empty() && has_wheels()) {
    // While no round comes the wheels' record would be forgotten before it is used.
    const std::int64_t kept = std::min(reading.utime - WheelHistory::kKept_us, history_.newest());
    if (kept > mixture_utime_) {
      motion_->predict(mixture_, mixture_utime_, kept);
      mixture_utime_ = kept;
    }
  }
  late_odometry_.passed();
  wheel_session_ = reading.session;
  const std::optional<WheelMotion> motion = counters_.motion(reading);
  faults_.tick_jumps = counters_.jumps();
  history_.add(reading.utime, motion.value_or(WheelMotion{}));
}

Localizer::Window Localizer::window_of(const TagRound& round) const {
  Window window;
  const auto nominal = static_cast<std::int64_t>(std::lround(1e6 * rfid_.round_time));
  window.length = round.window_end - round.window_start;
  if (round.window_known) {
    window.middle = round.window_start + window.length / 2;
    return window;
  }
  // The host's window spans two rounds when an answer was lost.
  if (window.length < nominal / 2 || window.length > nominal * 3 / 2) window.length = nominal;
  window.delay = parameters_.delay.mean;
  if (!mixture_.empty()) window.delay = moments(mixture_, -1).mean[kDelay];
  window.middle = round.utime - static_cast<std::int64_t>(std::lround(1e6 * window.delay));
  return window;
}

std::vector<int> Localizer::tags_of(const TagRound& round, std::vector<std::optional<std::int64_t>>& moments) {
  std::vector<int> tags;
  for (const TagRead& read : round.reads) {
    const std::optional<int> tag = map_.find(read.uid);
    if (!tag) {
      ++faults_.unknown_tags;
    } else if (std::find(tags.begin(), tags.end(), *tag) != tags.end()) {
      ++faults_.repeated_reads;
    } else {
      tags.push_back(*tag);
      const bool known = round.window_known && read.read_utime && *read.read_utime >= round.window_start &&
                         *read.read_utime <= round.window_end;
      moments.push_back(known ? read.read_utime : std::nullopt);
    }
  }
  return tags;
}

void Localizer::choose_motion(std::int64_t utime) {
  const bool wheels =
      !history_.empty() && kSeconds * static_cast<double>(utime - history_.newest()) <= parameters_.wheels_missing;
  const Motion* wanted = wheels ? static_cast<const Motion*>(&wheel_motion_) : &free_motion_;
  if (wanted == motion_) return;
  if (!mixture_.empty()) {
    // What lies before the wheels' record is inertia's still.
    if (wheels && mixture_utime_ < history_.oldest()) {
      motion_->predict(mixture_, mixture_utime_, history_.oldest());
      mixture_utime_ = history_.oldest();
    }
    // The place stays known; how the robot moves is learnt anew.
    const Hypothesis all = moments(mixture_, has_wheels() ? kHeading : -1);
    const AntennaView view = motion_->antenna(all, mixture_utime_, 0);
    const Place place{view.p_WF, view.H * all.covariance * view.H.transpose()};
    const DelayPrior delay{all.mean[kDelay], std::sqrt(all.covariance(kDelay, kDelay))};
    mixture_ = wanted->start(place, delay);
    if (wheels) wheel_motion_.set_heading(std::nullopt);
  }
  motion_ = wanted;
}

void Localizer::begin(const std::vector<int>& tags, const Window& window) {
  // The largest group of tags that one footprint can have reached.
  std::vector<int> group;
  const double reach = model_.reach();
  for (const int centre : tags) {
    std::vector<int> around;
    for (const int tag : tags) {
      if ((map_.position(tag) - map_.position(centre)).norm() <= 2.0 * reach) around.push_back(tag);
    }
    if (around.size() > group.size()) group = std::move(around);
  }
  Place place;
  for (const int tag : group) place.mean += map_.position(tag) / static_cast<double>(group.size());
  place.covariance = reach * reach * Eigen::Matrix2d::Identity();
  mixture_ = motion_->start(place, parameters_.delay);
  mixture_utime_ = window.middle;
  // Later, after turns, it is no longer the heading.
  if (has_wheels()) wheel_motion_.set_heading(std::nullopt);
}

double Localizer::position_sigma() const {
  const Hypothesis all = moments(mixture_, has_wheels() ? kHeading : -1);
  return larger_sigma(all.covariance.topLeftCorner<2, 2>());
}

void Localizer::require_possible(const TagRound& round) {
  if (last_round_ && round.utime <= *last_round_) {
    if (round.session == reader_session_ && !late_rounds_.persists()) {
      ++faults_.late_rounds;
      refuse_time("RFID_TAG_HITS", round.utime, *last_round_);
    }
    // Another reader, or a clock that was set back.
    last_round_.reset();
    paper_.restart();
    lose("RFID_TAG_HITS began anew at an earlier time");
  }
  late_rounds_.passed();
  if (!round.window_known) return;
  constexpr std::int64_t kOldest = 5'000'000;  // us; robot.yaml's longest delay
  const auto longest = static_cast<std::int64_t>(std::lround(3e6 * rfid_.round_time));
  const std::int64_t length = round.window_end - round.window_start;
  const std::int64_t age = round.utime - round.window_end;
  if (length >= 0 && length <= longest && age >= 0 && age <= kOldest) return;
  ++faults_.wrong_windows;
  throw std::invalid_argument("RFID_TAG_HITS: window of " + std::to_string(length) + " us that ended " +
                              std::to_string(age) + " us before utime; allowed: 0 to " + std::to_string(longest) +
                              " us, 0 to " + std::to_string(kOldest) + " us before");
}

void Localizer::observe(const TagRound& round) {
  require_possible(round);
  last_round_ = round.utime;
  reader_session_ = round.session;
  choose_motion(round.utime);

  std::vector<std::optional<std::int64_t>> moments_read;
  const std::vector<int> tags = tags_of(round, moments_read);
  std::vector<Eigen::Vector2d> places;
  for (const int tag : tags) places.push_back(map_.position(tag));
  const Window window = window_of(round);
  std::optional<double> speed;
  if (has_wheels()) speed = std::abs(history_.rate(window.middle, round.utime).way);
  if (auto paper = paper_.observe(round.utime, places, speed)) paper_estimate_ = paper;

  if (!mixture_.empty() && window.middle > mixture_utime_) {
    motion_->predict(mixture_, mixture_utime_, window.middle);
    mixture_utime_ = window.middle;
    if (position_sigma() > parameters_.hopeless_sigma) lose("too long without a tag of the map");
  }
  if (mixture_.empty()) {
    if (tags.empty()) return;
    begin(tags, window);
  }
  if (match(tags, moments_read, round, window)) lose("the reads contradict the pose");
}

bool Localizer::match(const std::vector<int>& tags, const std::vector<std::optional<std::int64_t>>& moments_read,
                      const TagRound& round, const Window& window) {
  const Hypothesis all = moments(mixture_, has_wheels() ? kHeading : -1);
  // Everywhere the antenna may have been, as far as the hypotheses go.
  const double sigma = larger_sigma(all.covariance.topLeftCorner<2, 2>());
  const double round_s = kSeconds * static_cast<double>(window.length);

  // Which of the reads can be real.
  std::vector<int> reachable;
  std::vector<std::optional<std::int64_t>> reachable_moments;
  const double farthest = model_.reach() + parameters_.match.span * sigma;
  for (std::size_t i = 0; i < tags.size(); ++i) {
    if ((map_.position(tags[i]) - all.mean.head<2>()).norm() > farthest + rfid_.p_RF.norm()) {
      ++faults_.far_tags;
    } else {
      reachable.push_back(tags[i]);
      reachable_moments.push_back(moments_read[i]);
    }
  }
  if (reachable.empty() && !tags.empty()) {
    return trust_.follow(Agreement::kContradicts, 0.0, sigma);  // nothing to learn from a round from elsewhere
  }

  double evidence = 0.0;
  double weights = 0.0;
  std::vector<int> near;
  std::vector<int> learnt;     // `near` of all hypotheses
  std::vector<double> inside;  // by that
  std::vector<double> chances;
  Mixture updated;
  for (Hypothesis& one : mixture_) {
    AntennaView view = motion_->antenna(one, window.middle, window.length);
    Eigen::Matrix<double, 2, 5> H = view.H;
    // Where the antenna was in the round's true middle: later than ours by what the delay is shorter, and by what the
    // mixture has not been led up to.
    if (!round.window_known) H.col(kDelay) = -view.velocity;
    const double earlier = round.window_known ? 0.0 : one.mean[kDelay] - window.delay;
    view.p_WF += (kSeconds * static_cast<double>(window.middle - mixture_utime_) - earlier) * view.velocity;
    const Eigen::Matrix2d S = H * one.covariance * H.transpose();
    const double own_sigma = larger_sigma(S);
    const double way = view.velocity.norm() * round_s;

    map_.near(view.p_WF, model_.reach() + parameters_.match.span * own_sigma + way, near);
    std::vector<TagOutcome> outcomes;
    for (const int tag : near) {
      TagOutcome outcome;
      outcome.p_W = map_.position(tag);
      outcome.reliability = reliability_.of(tag);
      const auto at = std::find(reachable.begin(), reachable.end(), tag);
      outcome.read = at != reachable.end();
      if (outcome.read) {
        const auto& moment = reachable_moments[static_cast<std::size_t>(at - reachable.begin())];
        outcome.moment_known = moment.has_value();
        if (moment) outcome.offset = kSeconds * static_cast<double>(*moment - window.middle) * view.velocity;
      }
      outcomes.push_back(outcome);
    }
    // A read that this hypothesis cannot explain speaks against it.
    double unexplained = 1.0;
    for (const int tag : reachable) {
      if (std::find(near.begin(), near.end(), tag) == near.end()) unexplained *= parameters_.match.false_read;
    }

    const RoundMatch found =
        match_round(view.p_WF, S, outcomes, window_points(view.velocity * round_s), model_, parameters_.match);
    const double before = one.weight;
    weights += before;
    one.weight *= std::max(found.evidence * unexplained, 1e-300);
    evidence += one.weight;
    // What is jointly Gaussian with the place follows it.
    const Eigen::Matrix<double, 5, 2> regression = one.covariance * H.transpose() * S.inverse();
    Eigen::Matrix<double, 5, 2> K = regression;
    if (!motion_->learns_delay()) K.row(kDelay).setZero();
    for (const PlacePart& part : found.parts) {
      Hypothesis next;
      next.mode = one.mode;
      next.weight = one.weight * part.share;
      next.mean = one.mean + K * (part.mean - view.p_WF);
      const Eigen::Matrix<double, 5, 5> cross = K * (S - part.covariance) * regression.transpose();
      next.covariance = one.covariance - cross - cross.transpose() + K * (S - part.covariance) * K.transpose();
      next.covariance = 0.5 * (next.covariance + next.covariance.transpose()).eval();
      updated.push_back(next);
    }
    for (std::size_t k = 0; k < near.size(); ++k) {
      const auto at = std::find(learnt.begin(), learnt.end(), near[k]);
      if (at == learnt.end()) {
        learnt.push_back(near[k]);
        inside.push_back(one.weight * found.inside[k]);
        chances.push_back(before * found.chance[k]);
      } else {
        const auto place = static_cast<std::size_t>(at - learnt.begin());
        inside[place] += one.weight * found.inside[k];
        chances[place] += before * found.chance[k];
      }
    }
  }
  bool explained = false;  // some read, by a place that the antenna may have been at
  for (std::size_t k = 0; k < learnt.size(); ++k) {
    const bool read = std::find(reachable.begin(), reachable.end(), learnt[k]) != reachable.end();
    explained = explained || (read && inside[k] / evidence >= parameters_.trust.explained);
  }
  // Only a round that hears something tells which tags are silent: a reader that hears nothing would unlearn the map.
  for (std::size_t k = 0; explained && k < learnt.size(); ++k) {
    const bool read = std::find(reachable.begin(), reachable.end(), learnt[k]) != reachable.end();
    reliability_.learn(learnt[k], read, inside[k] / evidence);
  }
  for (double& chance : chances) chance /= weights;
  const double surprised = surprise(chances, std::log(evidence / weights), parameters_.match.false_read);
  motion_->clean(updated);
  mixture_ = std::move(updated);

  if (reachable.empty()) return trust_.follow_silence(evidence / weights);
  return trust_.follow(explained ? Agreement::kAgrees : Agreement::kContradicts, surprised, position_sigma());
}

Estimate Localizer::estimate(std::int64_t utime) const {
  Estimate estimate;
  estimate.paper = paper_estimate_;
  estimate.delay = parameters_.delay;
  // A round from far ahead of now is of another clock, and no news either.
  const double since_round = last_round_ ? std::abs(kSeconds * static_cast<double>(utime - *last_round_)) : 0.0;
  if (mixture_.empty()) {
    constexpr double kNowhere = 1e4;  // m^2: no place is known
    estimate.pose.covariance.diagonal() << kNowhere, kNowhere, M_PI * M_PI / 3.0;
    estimate.placement = trust_.placement(std::sqrt(kNowhere), since_round);
    estimate.reason = trust_.reason(std::sqrt(kNowhere), since_round);
    return estimate;
  }
  Mixture now = mixture_;
  motion_->predict(now, mixture_utime_, utime);
  estimate.pose = motion_->pose(now, utime);
  const Hypothesis all = moments(now, -1);
  estimate.delay = {all.mean[kDelay], std::sqrt(std::max(0.0, all.covariance(kDelay, kDelay)))};
  estimate.odometry_used = has_wheels();
  const double sigma = larger_sigma(estimate.pose.covariance.topLeftCorner<2, 2>());
  estimate.placement = trust_.placement(sigma, since_round);
  estimate.reason = trust_.reason(sigma, since_round);
  return estimate;
}

}  // namespace markservo::rfid_localizer
