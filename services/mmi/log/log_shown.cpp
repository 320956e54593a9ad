#include "services/mmi/log/log_shown.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <markservo/channels.hpp>

namespace markservo::mmi {
namespace {

// us, `seconds` after `at`, or the last moment there is: a damaged log's times may be anything.
std::int64_t later(std::int64_t at, double seconds) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(at, static_cast<std::int64_t>(1e6 * seconds), &sum)) return sum;
  return seconds > 0.0 ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

}  // namespace

LogShown::LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world, const Parameters& parameters)
    : index_(index), events_(events), make_world_(std::move(make_world)), parameters_(parameters) {
  seek(index_.pictures().empty() ? index_.end() : complete_at(0));
}

double LogShown::seconds(std::int64_t at) const {
  return logs::seconds_apart(index_.begin(), at);
}

std::int64_t LogShown::complete_at(std::size_t picture) const {
  const std::vector<std::size_t>& pictures = index_.pictures();
  const std::int64_t latest = later(index_.events()[pictures[picture]].at, parameters_.patience);
  if (picture + 1 == pictures.size()) return latest;
  const std::int64_t next = index_.events()[pictures[picture + 1]].at;
  return std::min(latest, next > index_.begin() ? next - 1 : next);
}

void LogShown::hear(std::size_t event) {
  const LogIndex::Event& heard = index_.events()[event];
  world_->observe(*heard.channel, heard.data.data, heard.data.size, heard.at, seconds(heard.at));
}

void LogShown::seek(std::int64_t at) {
  at_ = std::clamp(at, index_.begin(), later(index_.end(), parameters_.patience));
  heard_ = index_.count_until(at_);
  world_ = make_world_();
  ++generation_;
  ++changes_;
  const std::size_t first = index_.count_until(later(at_, -parameters_.heard_before));
  const std::size_t first_picture = index_.count_until(later(at_, -parameters_.pictures_before));
  const std::vector<std::size_t> newest = index_.newest_of(heard_);
  // What was said last before the stretch that is heard anew, and the last picture wherever it is.
  for (const std::size_t event : newest) {
    const bool is_picture = *index_.events()[event].channel == channels::kStereoFrame.name;
    if (event < (is_picture ? first_picture : first)) hear(event);
  }
  for (std::size_t event = first; event < heard_; ++event) {
    if (event < first_picture && *index_.events()[event].channel == channels::kStereoFrame.name) continue;
    hear(event);
  }
  world_->advance(at_, seconds(at_));
}

void LogShown::step(int frames) {
  const std::vector<std::size_t>& pictures = index_.pictures();
  if (pictures.empty()) return;
  const std::shared_ptr<const Frame> shown = world_->frames().ready(world_->now());
  std::ptrdiff_t number = -1;  // of the picture shown; -1: before the first
  if (shown) {
    const auto at_frame =
        std::lower_bound(pictures.begin(), pictures.end(), shown->at,
                         [this](std::size_t event, std::int64_t at) { return index_.events()[event].at < at; });
    number = at_frame - pictures.begin();
  }
  const auto last = static_cast<std::ptrdiff_t>(pictures.size()) - 1;
  seek(complete_at(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(number + frames, 0, last))));
}

void LogShown::advance(double now) {
  const double passed = advanced_at_ ? std::min(now - *advanced_at_, parameters_.longest_step) : 0.0;
  advanced_at_ = now;
  if (!playing_) return;
  const std::int64_t end = later(index_.end(), parameters_.patience);
  at_ = std::min(later(at_, speed_ * passed), end);
  if (at_ == end) playing_ = false;
  const std::size_t until = index_.count_until(at_);
  for (; heard_ < until; ++heard_) hear(heard_);
  world_->advance(at_, seconds(at_));
  ++changes_;
}

VersionedText LogShown::play() const {
  return {changes_, fmt::format("{{\"utime\":\"{}\",\"playing\":{},\"speed\":{}}}", at_, playing_, speed_)};
}

std::string LogShown::control(const ClientWord& message) {
  if (const auto* play = std::get_if<ClientPlay>(&message)) {
    if (at_ >= index_.end()) seek(index_.begin());
    playing_ = true;
    speed_ = play->speed;
  } else if (std::holds_alternative<ClientPause>(message)) {
    playing_ = false;
  } else if (const auto* wanted = std::get_if<ClientSeek>(&message)) {
    seek(wanted->utime);
  } else if (const auto* wished = std::get_if<ClientStep>(&message)) {
    playing_ = false;
    step(wished->frames);
  }
  ++changes_;
  return {};
}

}  // namespace markservo::mmi
