#include "services/simulator/readers/rfid_reader_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

constexpr double kNegligibleEdge = 14.0;  // softnesses beyond the radius: one read in a million
constexpr double kFarAway = 3.0;          // reading radii: where no reader could hear it

void require_share(const char* what, double value) {
  if (value >= 0.0 && value <= 1.0) return;
  throw std::invalid_argument(std::string("RfidReaderModel: ") + what + " is " + std::to_string(value) +
                              "; allowed: 0 to 1");
}

void require_times(const robot::RfidDescription& reader, const RfidReaderParameters& parameters) {
  const double delay = parameters.delay.value_or(reader.delay);
  if (!(delay >= 0.5 * reader.round_time && delay <= 10.0)) {
    throw std::invalid_argument("RfidReaderModel: delay is " + std::to_string(delay) + " s; allowed: half a round, " +
                                std::to_string(0.5 * reader.round_time) + " s, to 10 s");
  }
  if (!(parameters.delay_jitter >= 0.0 && parameters.delay_jitter <= 1.0)) {
    throw std::invalid_argument("RfidReaderModel: delay_jitter is " + std::to_string(parameters.delay_jitter) +
                                " s; allowed: 0 to 1 s");
  }
}

Eigen::Vector2d between(double share, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return from + share * (to - from);
}

std::string random_uid(RandomBits& bits) {
  return fmt::format("{:016X}", bits.next());
}

}  // namespace

RfidReaderModel::RfidReaderModel(const robot::RfidDescription& reader, const RfidReaderParameters& parameters,
                                 TagFloor floor, std::uint64_t seed)
    : reader_(reader), floor_(std::move(floor)), seed_(seed), round_us_(std::llround(reader.round_time * 1e6)) {
  change(parameters);
}

void RfidReaderModel::change(const RfidReaderParameters& parameters) {
  require_times(reader_, parameters);
  require_share("missed", parameters.missed);
  require_share("duplicates", parameters.duplicates);
  require_share("unknown_tags", parameters.unknown_tags);
  require_share("false_reads", parameters.false_reads);
  parameters_ = parameters;
}

double RfidReaderModel::read_probability(double distance) const {
  const double edge = (distance - reader_.reading_radius) / reader_.edge_softness;
  return (1.0 - parameters_.missed) * reader_.read_probability / (1.0 + std::exp(edge));
}

double RfidReaderModel::rssi(double distance, double noise) const {
  const double height = parameters_.antenna_height;
  const double way = std::hypot(distance, height);
  return parameters_.rssi_near - 10.0 * parameters_.path_loss_exponent * std::log10(way / height) +
         parameters_.rssi_noise * noise;
}

void RfidReaderModel::observe(std::int64_t utime, const geometry::PlanePose& X_WR) {
  const Antenna now{utime, X_WR * reader_.p_RF};
  if (!last_) {
    last_ = now;
    round_start_ = utime;
    return;
  }
  if (utime <= last_->utime) {
    throw std::invalid_argument("RfidReaderModel: utime is " + std::to_string(utime) + "; allowed: above " +
                                std::to_string(last_->utime));
  }
  for (std::int64_t begin = last_->utime; begin < utime;) {
    const std::int64_t end = std::min(utime, round_end());
    read_between(*last_, now, begin, end);
    begin = end;
    if (end == round_end()) finish_round(now.p_W);
  }
  last_ = now;
}

// Every tag has one moment per round, drawn from the round's and its own number: the same at any step size.
void RfidReaderModel::read_between(const Antenna& from, const Antenna& to, std::int64_t begin, std::int64_t end) {
  const double reach = reader_.reading_radius + kNegligibleEdge * reader_.edge_softness;
  const double half_way = 0.5 * (to.p_W - from.p_W).norm();
  for (const int i : floor_.near(between(0.5, from.p_W, to.p_W), reach + half_way)) {
    RandomBits bits(
        seed_for(seed_for(seed_, streams::kTagRead, round_), streams::kTagRead, static_cast<std::uint64_t>(i)));
    const auto into_round = static_cast<std::int64_t>(bits.uniform() * static_cast<double>(round_us_));
    const std::int64_t moment = round_start_ + into_round;
    if (moment < begin || moment >= end) continue;
    const double share = static_cast<double>(moment - from.utime) / static_cast<double>(to.utime - from.utime);
    const robot::FloorTag& tag = floor_.tags()[static_cast<std::size_t>(i)];
    const double distance = (tag.p_W - between(share, from.p_W, to.p_W)).norm();
    if (bits.uniform() >= read_probability(distance)) continue;
    reads_.push_back({moment, tag.uid, rssi(distance, bits.gaussian())});
    if (bits.uniform() >= parameters_.duplicates) continue;
    const double rest = bits.uniform() * static_cast<double>(round_end() - moment);
    reads_.push_back({moment + static_cast<std::int64_t>(rest), tag.uid, rssi(distance, bits.gaussian())});
  }
}

void RfidReaderModel::add_strays(const Eigen::Vector2d& p_WF) {
  RandomBits bits(seed_for(seed_, streams::kStrayRead, round_));
  const auto moment = [&] {
    return round_start_ + static_cast<std::int64_t>(bits.uniform() * static_cast<double>(round_us_));
  };
  if (bits.uniform() < parameters_.unknown_tags) {
    std::string uid = random_uid(bits);
    while (floor_.maps(uid)) uid = random_uid(bits);
    reads_.push_back({moment(), uid, rssi(reader_.reading_radius * bits.uniform(), bits.gaussian())});
  }
  if (floor_.tags().empty() || bits.uniform() >= parameters_.false_reads) return;
  constexpr int kTries = 50;  // a floor may be all near
  for (int i = 0; i < kTries; ++i) {
    const auto pick = static_cast<std::size_t>(bits.uniform() * static_cast<double>(floor_.tags().size()));
    const robot::FloorTag& tag = floor_.tags()[pick];
    if ((tag.p_W - p_WF).norm() < kFarAway * reader_.reading_radius) continue;
    reads_.push_back({moment(), tag.uid, rssi(reader_.reading_radius, bits.gaussian())});
    return;
  }
}

void RfidReaderModel::finish_round(const Eigen::Vector2d& p_WF) {
  add_strays(p_WF);
  std::stable_sort(reads_.begin(), reads_.end(), [](const Read& a, const Read& b) { return a.utime < b.utime; });

  const double jitter = parameters_.delay_jitter * RandomBits(seed_for(seed_, streams::kReadDelay, round_)).symmetric();
  const double delay = parameters_.delay.value_or(reader_.delay) + jitter;
  TagRound round;
  round.utime = round_start_ + round_us_ / 2 + std::llround(delay * 1e6);
  round.utime = std::max({round.utime, round_end(), last_arrival_ + 1});
  round.window_known = parameters_.read_time_known;
  if (round.window_known) {
    round.window_start = round_start_;
    round.window_end = round_end();
  } else {
    round.window_start = last_arrival_ == 0 ? round.utime - round_us_ : last_arrival_;
    round.window_end = round.utime;
  }
  for (const Read& read : reads_) {
    round.hits.push_back({read.uid, round.utime, round.window_known ? read.utime : 0, round.window_known, read.rssi});
  }
  last_arrival_ = round.utime;
  under_way_.push_back(std::move(round));
  reads_.clear();
  round_start_ += round_us_;
  ++round_;
}

std::vector<TagRound> RfidReaderModel::take_arrived(std::int64_t utime) {
  std::vector<TagRound> arrived;
  while (!under_way_.empty() && under_way_.front().utime <= utime) {
    arrived.push_back(std::move(under_way_.front()));
    under_way_.pop_front();
  }
  return arrived;
}

}  // namespace markservo::simulator
