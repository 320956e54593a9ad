#include "services/rfid-localizer/localizer.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/time/seconds_between.hpp"
#include "services/rfid-localizer/surprise.hpp"

namespace markservo::rfid_localizer {
namespace {

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
      floor_{TagMap(field, rfid.reading_radius),
             ReadModel(rfid.reading_radius, blurred(rfid.edge_softness, parameters.survey_sigma)),
             TagReliability(field.tags.size(), parameters.reliability)},
      counters_(base),
      motion_(history_, rfid.p_RF, parameters.wheels, parameters.free, parameters.judge),
      paper_(parameters.paper),
      trust_(parameters.trust) {
  motion_.set_heading(parameters.start_heading);
}

void Localizer::lose(const std::string& why) {
  belief_.mixture.clear();
  motion_.restart_judging();
  trust_.lose(why);
  // What was known of the heading at the start is past.
  motion_.set_heading(std::nullopt);
}

void Localizer::begin_anew(const std::string& why) {
  round_times_.forget();
  paper_.forget();
  lose(why);
}

LocalizerFaults Localizer::faults() const {
  LocalizerFaults faults = faults_;
  faults.tick_jumps = counters_.jumps();
  return faults;
}

void Localizer::observe(const EncoderReading& reading) {
  const InputTimes::Step step = odometry_times_.judge(reading.utime, reading.session);
  if (step == InputTimes::Step::kLate) {
    ++faults_.late_odometry;
    refuse_time("WHEEL_ODOMETRY", reading.utime, *odometry_times_.last());
  }
  if (step == InputTimes::Step::kAnew) {
    // All that was known belongs to another time.
    history_.forget();
    counters_.forget();
    begin_anew("WHEEL_ODOMETRY began anew at an earlier time");
  }
  if (!belief_.empty() && has_wheels()) {
    // While no round comes the wheels' record would be forgotten before it is used.
    const std::int64_t kept = std::min(reading.utime - WheelHistory::kKept_us, history_.newest());
    if (kept > belief_.utime) motion_.predict(belief_, kept);
  }
  const std::optional<WheelMotion> motion = counters_.motion(reading);
  odometry_times_.accept(reading.utime, reading.session);
  history_.add(reading.utime, motion.value_or(WheelMotion{}));
}

RoundTime Localizer::time_of(const TagRound& round) const {
  RoundTime time;
  time.known = round.window_known;
  time.length = round.window_end - round.window_start;
  if (time.known) {
    time.middle = round.window_start + time.length / 2;
    return time;
  }
  // The host's window spans two rounds when an answer was lost.
  const auto nominal = static_cast<std::int64_t>(std::lround(1e6 * rfid_.round_time));
  if (time.length < nominal / 2 || time.length > nominal * 3 / 2) time.length = nominal;
  time.delay = belief_.empty() ? parameters_.delay.mean : whole().mean[kDelay];
  time.middle = round.utime - static_cast<std::int64_t>(std::lround(1e6 * time.delay));
  return time;
}

std::vector<HeardTag> Localizer::heard_in(const TagRound& round) {
  std::vector<HeardTag> heard;
  for (const TagRead& read : round.reads) {
    const std::optional<int> tag = floor_.map.find(read.uid);
    const auto is_it = [&tag](const HeardTag& one) { return one.tag == *tag; };
    if (!tag) {
      ++faults_.unknown_tags;
    } else if (std::any_of(heard.begin(), heard.end(), is_it)) {
      ++faults_.repeated_reads;
    } else {
      const bool known = round.window_known && read.read_utime && *read.read_utime >= round.window_start &&
                         *read.read_utime <= round.window_end;
      heard.push_back({*tag, known ? read.read_utime : std::nullopt});
    }
  }
  return heard;
}

void Localizer::choose_motion(std::int64_t utime) {
  const bool wheels = !history_.empty() && seconds_between(history_.newest(), utime) <= parameters_.wheels_missing;
  if (wheels == motion_.by_wheels()) return;
  if (!belief_.empty()) {
    // What lies before the wheels' record is inertia's still.
    if (wheels && belief_.utime < history_.oldest()) motion_.predict(belief_, history_.oldest());
    // The place stays known; how the robot moves is learnt anew.
    const Hypothesis all = whole();
    const AntennaView view = motion_.now().antenna(all, belief_.utime, 0);
    const Place place{view.p_WF, view.H * all.covariance * view.H.transpose()};
    const DelayPrior delay{all.mean[kDelay], std::sqrt(all.covariance(kDelay, kDelay))};
    belief_.mixture = motion_.of(wheels).start(place, delay);
    if (wheels) motion_.set_heading(std::nullopt);
  }
  motion_.choose(wheels);
}

void Localizer::begin(const std::vector<HeardTag>& heard, std::int64_t utime) {
  // The largest group of tags that one footprint can have reached.
  std::vector<Eigen::Vector2d> group;
  const double reach = floor_.model.reach();
  for (const HeardTag& centre : heard) {
    std::vector<Eigen::Vector2d> around;
    for (const HeardTag& one : heard) {
      const Eigen::Vector2d& p_W = floor_.map.position(one.tag);
      if ((p_W - floor_.map.position(centre.tag)).norm() <= 2.0 * reach) around.push_back(p_W);
    }
    if (around.size() > group.size()) group = std::move(around);
  }
  Place place;
  for (const Eigen::Vector2d& p_W : group) place.mean += p_W / static_cast<double>(group.size());
  place.covariance = reach * reach * Eigen::Matrix2d::Identity();
  belief_ = {motion_.now().start(place, parameters_.delay), utime};
  // Later, after turns, it is no longer the heading.
  if (has_wheels()) motion_.set_heading(std::nullopt);
}

Hypothesis Localizer::whole() const {
  return moments(belief_.mixture, motion_.now().angle());
}

double Localizer::position_sigma() const {
  return larger_sigma(whole().place());
}

void Localizer::check_window(const TagRound& round) {
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

void Localizer::follow_time(const TagRound& round) {
  const InputTimes::Step step = round_times_.judge(round.utime, round.session);
  if (step == InputTimes::Step::kLate) {
    ++faults_.late_rounds;
    refuse_time("RFID_TAG_HITS", round.utime, *round_times_.last());
  }
  if (step == InputTimes::Step::kAnew) begin_anew("RFID_TAG_HITS began anew at an earlier time");
  round_times_.accept(round.utime, round.session);
}

void Localizer::observe(const TagRound& round) {
  check_window(round);
  follow_time(round);
  choose_motion(round.utime);

  const std::vector<HeardTag> heard = heard_in(round);
  const RoundTime time = time_of(round);
  std::vector<Eigen::Vector2d> places;
  for (const HeardTag& one : heard) places.push_back(floor_.map.position(one.tag));
  std::optional<double> speed;
  if (has_wheels()) speed = std::abs(history_.rate(time.middle, round.utime).way);
  paper_.observe(round.utime, places, speed);

  if (!belief_.empty() && time.middle > belief_.utime) {
    motion_.predict(belief_, time.middle);
    if (position_sigma() > parameters_.hopeless_sigma) lose("too long without a tag of the map");
  }
  if (belief_.empty()) {
    if (heard.empty()) return;
    begin(heard, time.middle);
  }
  if (match(heard, time)) lose("the reads contradict the pose");
}

std::vector<HeardTag> Localizer::reachable(const std::vector<HeardTag>& heard) {
  const Hypothesis all = whole();
  const double farthest = floor_.model.reach() + parameters_.match.span * larger_sigma(all.place()) + rfid_.p_RF.norm();
  std::vector<HeardTag> result;
  for (const HeardTag& one : heard) {
    if ((floor_.map.position(one.tag) - all.mean.head<2>()).norm() <= farthest) result.push_back(one);
  }
  faults_.far_tags += static_cast<std::int64_t>(heard.size() - result.size());
  return result;
}

bool Localizer::match(const std::vector<HeardTag>& heard, const RoundTime& time) {
  const std::vector<HeardTag> reads = reachable(heard);
  if (reads.empty() && !heard.empty()) {
    return trust_.follow(Agreement::kContradicts, 0.0, position_sigma());  // a round from elsewhere teaches nothing
  }
  RoundUpdate round = update(belief_, motion_.now(), time, reads, floor_, parameters_.match);
  const bool explained = std::any_of(round.tags.begin(), round.tags.end(), [this](const TagTally& one) {
    return one.read && one.inside >= parameters_.trust.explained;
  });
  std::vector<double> chances;
  for (const TagTally& one : round.tags) {
    chances.push_back(one.chance);
    // Only a round that hears something tells which tags are silent: a reader that hears nothing would unlearn the map.
    if (explained) floor_.reliability.learn(one.tag, one.read, one.inside);
  }
  const Hypothesis before = whole();
  motion_.judge(before, moments(round.mixture, motion_.now().angle()),
                antenna_in_the_middle(before, belief_.utime, motion_.now(), time));
  motion_.now().clean(round.mixture);
  belief_.mixture = std::move(round.mixture);
  if (reads.empty()) return trust_.follow_silence(round.probability);
  const double surprised = surprise(chances, std::log(round.probability), parameters_.match.false_read);
  return trust_.follow(explained ? Agreement::kAgrees : Agreement::kContradicts, surprised, position_sigma());
}

Estimate Localizer::estimate(std::int64_t utime) const {
  Estimate estimate;
  estimate.paper = paper_.newest();
  estimate.delay = parameters_.delay;
  // A round from far ahead of now is of another clock, and no news either.
  const auto& last_round = round_times_.last();
  const double since_round = last_round ? std::abs(seconds_between(*last_round, utime)) : 0.0;
  if (belief_.empty()) {
    constexpr double kNowhere = 1e4;  // m^2: no place is known
    estimate.pose.covariance.diagonal() << kNowhere, kNowhere, kAnyHeading;
    estimate.placement = trust_.placement(std::sqrt(kNowhere), since_round);
    estimate.reason = trust_.reason(std::sqrt(kNowhere), since_round);
    return estimate;
  }
  Belief now = belief_;
  now.predict(motion_.now(), utime);
  estimate.pose = motion_.now().pose(now.mixture, utime);
  const Hypothesis all = moments(now.mixture, -1);
  estimate.delay = {all.mean[kDelay], std::sqrt(std::max(0.0, all.covariance(kDelay, kDelay)))};
  estimate.odometry_used = has_wheels();
  const double sigma = larger_sigma(estimate.pose.covariance.topLeftCorner<2, 2>());
  estimate.placement = trust_.placement(sigma, since_round);
  estimate.reason = trust_.reason(sigma, since_round);
  return estimate;
}

}  // namespace markservo::rfid_localizer
