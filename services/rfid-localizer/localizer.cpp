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
      map_(field, rfid.reading_radius),
      model_(rfid.reading_radius, blurred(rfid.edge_softness, parameters.survey_sigma)),
      reliability_(field.tags.size(), parameters.reliability),
      counters_(base),
      wheel_motion_(history_, rfid.p_RF, parameters.wheels),
      free_motion_(rfid.p_RF, parameters.free),
      judge_(parameters.wheels.noise, parameters.judge),
      motion_(&free_motion_),
      paper_(parameters.paper),
      trust_(parameters.trust) {
  wheel_motion_.set_heading(parameters.start_heading);
}

void Localizer::lose(const std::string& why) {
  mixture_.clear();
  judge_.restart();
  trust_.lose(why);
  // What was known of the heading at the start is past.
  wheel_motion_.set_heading(std::nullopt);
}

void Localizer::begin_anew(const std::string& why) {
  last_round_.reset();
  paper_.restart();
  paper_estimate_.reset();
  lose(why);
}

LocalizerFaults Localizer::faults() const {
  LocalizerFaults faults = faults_;
  faults.tick_jumps = counters_.jumps();
  return faults;
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
    begin_anew("WHEEL_ODOMETRY began anew at an earlier time");
  }
  if (!mixture_.empty() && has_wheels()) {
    // While no round comes the wheels' record would be forgotten before it is used.
    const std::int64_t kept = std::min(reading.utime - WheelHistory::kKept_us, history_.newest());
    if (kept > mixture_utime_) predict_to(kept);
  }
  late_odometry_.passed();
  wheel_session_ = reading.session;
  const std::optional<WheelMotion> motion = counters_.motion(reading);
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
  time.delay = mixture_.empty() ? parameters_.delay.mean : whole().mean[kDelay];
  time.middle = round.utime - static_cast<std::int64_t>(std::lround(1e6 * time.delay));
  return time;
}

std::vector<HeardTag> Localizer::heard_in(const TagRound& round) {
  std::vector<HeardTag> heard;
  for (const TagRead& read : round.reads) {
    const std::optional<int> tag = map_.find(read.uid);
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
  const Motion* wanted = wheels ? static_cast<const Motion*>(&wheel_motion_) : &free_motion_;
  if (wanted == motion_) return;
  if (!mixture_.empty()) {
    // What lies before the wheels' record is inertia's still.
    if (wheels && mixture_utime_ < history_.oldest()) {
      predict_to(history_.oldest());
    }
    // The place stays known; how the robot moves is learnt anew.
    const Hypothesis all = whole();
    const AntennaView view = motion_->antenna(all, mixture_utime_, 0);
    const Place place{view.p_WF, view.H * all.covariance * view.H.transpose()};
    const DelayPrior delay{all.mean[kDelay], std::sqrt(all.covariance(kDelay, kDelay))};
    mixture_ = wanted->start(place, delay);
    judge_.restart();
    if (wheels) wheel_motion_.set_heading(std::nullopt);
  }
  motion_ = wanted;
}

void Localizer::begin(const std::vector<HeardTag>& heard, std::int64_t utime) {
  // The largest group of tags that one footprint can have reached.
  std::vector<Eigen::Vector2d> group;
  const double reach = model_.reach();
  for (const HeardTag& centre : heard) {
    std::vector<Eigen::Vector2d> around;
    for (const HeardTag& one : heard) {
      const Eigen::Vector2d& p_W = map_.position(one.tag);
      if ((p_W - map_.position(centre.tag)).norm() <= 2.0 * reach) around.push_back(p_W);
    }
    if (around.size() > group.size()) group = std::move(around);
  }
  Place place;
  for (const Eigen::Vector2d& p_W : group) place.mean += p_W / static_cast<double>(group.size());
  place.covariance = reach * reach * Eigen::Matrix2d::Identity();
  mixture_ = motion_->start(place, parameters_.delay);
  mixture_utime_ = utime;
  // Later, after turns, it is no longer the heading.
  if (has_wheels()) wheel_motion_.set_heading(std::nullopt);
}

void Localizer::predict_to(std::int64_t utime) {
  if (has_wheels() && parameters_.judge_wheels) {
    StateVector state = whole().mean;
    history_.replay(mixture_utime_, utime, [&](const WheelMotion& piece) {
      judge_.moved(state, piece);
      Hypothesis next;
      next.mean = state;
      advance(next, piece, judge_.believed());
      state = next.mean;
    });
  }
  motion_->predict(mixture_, mixture_utime_, utime);
  mixture_utime_ = utime;
}

void Localizer::judge(const Hypothesis& before, const Hypothesis& after, const RoundTime& time) {
  if (!has_wheels() || !parameters_.judge_wheels) return;
  AntennaView view = motion_->antenna(before, time.middle, time.length);
  if (!time.known) view.H.col(kDelay) = -view.velocity;
  judge_.matched(before, after, view.H);
  wheel_motion_.set_noise(judge_.believed());
}

Hypothesis Localizer::whole() const {
  return moments(mixture_, motion_->angle());
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
  if (last_round_ && round.utime <= *last_round_) {
    if (round.session == reader_session_ && !late_rounds_.persists()) {
      ++faults_.late_rounds;
      refuse_time("RFID_TAG_HITS", round.utime, *last_round_);
    }
    // Another reader, or a clock that was set back.
    begin_anew("RFID_TAG_HITS began anew at an earlier time");
  }
  late_rounds_.passed();
  last_round_ = round.utime;
  reader_session_ = round.session;
}

void Localizer::observe(const TagRound& round) {
  check_window(round);
  follow_time(round);
  choose_motion(round.utime);

  const std::vector<HeardTag> heard = heard_in(round);
  const RoundTime time = time_of(round);
  std::vector<Eigen::Vector2d> places;
  for (const HeardTag& one : heard) places.push_back(map_.position(one.tag));
  std::optional<double> speed;
  if (has_wheels()) speed = std::abs(history_.rate(time.middle, round.utime).way);
  if (auto paper = paper_.observe(round.utime, places, speed)) paper_estimate_ = paper;

  if (!mixture_.empty() && time.middle > mixture_utime_) {
    predict_to(time.middle);
    if (position_sigma() > parameters_.hopeless_sigma) lose("too long without a tag of the map");
  }
  if (mixture_.empty()) {
    if (heard.empty()) return;
    begin(heard, time.middle);
  }
  if (match(heard, time)) lose("the reads contradict the pose");
}

std::vector<HeardTag> Localizer::reachable(const std::vector<HeardTag>& heard) {
  const Hypothesis all = whole();
  const double farthest = model_.reach() + parameters_.match.span * larger_sigma(all.place()) + rfid_.p_RF.norm();
  std::vector<HeardTag> result;
  for (const HeardTag& one : heard) {
    if ((map_.position(one.tag) - all.mean.head<2>()).norm() <= farthest) result.push_back(one);
  }
  faults_.far_tags += static_cast<std::int64_t>(heard.size() - result.size());
  return result;
}

bool Localizer::match(const std::vector<HeardTag>& heard, const RoundTime& time) {
  const std::vector<HeardTag> reads = reachable(heard);
  if (reads.empty() && !heard.empty()) {
    return trust_.follow(Agreement::kContradicts, 0.0, position_sigma());  // a round from elsewhere teaches nothing
  }
  RoundUpdate round =
      update(mixture_, mixture_utime_, *motion_, time, reads, {map_, model_, reliability_}, parameters_.match);
  const bool explained = std::any_of(round.tags.begin(), round.tags.end(), [this](const TagTally& one) {
    return one.read && one.inside >= parameters_.trust.explained;
  });
  std::vector<double> chances;
  for (const TagTally& one : round.tags) {
    chances.push_back(one.chance);
    // Only a round that hears something tells which tags are silent: a reader that hears nothing would unlearn the map.
    if (explained) reliability_.learn(one.tag, one.read, one.inside);
  }
  judge(whole(), moments(round.mixture, motion_->angle()), time);
  motion_->clean(round.mixture);
  mixture_ = std::move(round.mixture);
  if (reads.empty()) return trust_.follow_silence(round.probability);
  const double surprised = surprise(chances, std::log(round.probability), parameters_.match.false_read);
  return trust_.follow(explained ? Agreement::kAgrees : Agreement::kContradicts, surprised, position_sigma());
}

Estimate Localizer::estimate(std::int64_t utime) const {
  Estimate estimate;
  estimate.paper = paper_estimate_;
  estimate.delay = parameters_.delay;
  // A round from far ahead of now is of another clock, and no news either.
  const double since_round = last_round_ ? std::abs(seconds_between(*last_round_, utime)) : 0.0;
  if (mixture_.empty()) {
    constexpr double kNowhere = 1e4;  // m^2: no place is known
    estimate.pose.covariance.diagonal() << kNowhere, kNowhere, kAnyHeading;
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
