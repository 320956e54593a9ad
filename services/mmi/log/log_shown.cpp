#include "services/mmi/log/log_shown.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <markservo/channels.hpp>
#include <utility>

namespace markservo::mmi {
namespace {

constexpr int kMostSteps = 1000;  // wished at once: more is nobody's wish

// us, `seconds` after `at`, or the last moment there is: a damaged log's times may be anything.
std::int64_t later(std::int64_t at, double seconds) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(at, static_cast<std::int64_t>(1e6 * seconds), &sum)) return sum;
  return seconds > 0.0 ? std::numeric_limits<std::int64_t>::max() : std::numeric_limits<std::int64_t>::min();
}

}  // namespace

LogShown::LogShown(const LogIndex& index, const EventLog& events, MakeWorld make_world, const Parameters& parameters)
    : index_(index), events_(events), make_world_(std::move(make_world)), parameters_(parameters) {}

double LogShown::seconds(std::int64_t at) const {
  return logs::seconds_apart(index_.begin(), at);
}

void LogShown::show_picture(std::size_t number) {
  const std::int64_t at = index_.events()[index_.pictures()[number]].at;
  seek(later(at, parameters_.patience));
  stepped_to_ = at;
}

void LogShown::fulfil() {
  if (!wish_.at && wish_.frames == 0 && world_) return;
  const Wish wish = std::exchange(wish_, {});
  if (wish.at) {
    seek(*wish.at);
  } else if (!world_) {
    begin();
  }
  if (wish.frames != 0) step(wish.frames);
  ++changes_;
}

void LogShown::begin() {
  if (index_.pictures().empty()) return seek(index_.end());
  show_picture(0);
}

WorldReader& LogShown::world() {
  fulfil();
  return *world_;
}

std::uint64_t LogShown::generation() {
  fulfil();
  return generation_;
}

std::int64_t LogShown::utime() {
  fulfil();
  return at_;
}

std::shared_ptr<const Frame> LogShown::picture() {
  fulfil();
  const std::shared_ptr<const Frame> stepped = stepped_to_ ? world_->frames().of(*stepped_to_) : nullptr;
  return stepped ? stepped : Shown::picture();
}

bool LogShown::is_picture(std::size_t event) const {
  return *index_.events()[event].channel == channels::kStereoFrame.name;
}

void LogShown::hear(std::size_t event) {
  const LogIndex::Event& heard = index_.events()[event];
  world_->observe(*heard.channel, heard.data.data, heard.data.size, heard.at, seconds(heard.at));
}

void LogShown::seek(std::int64_t at) {
  at_ = std::clamp(at, index_.begin(), later(index_.end(), parameters_.patience));
  heard_ = index_.count_until(at_);
  stepped_to_.reset();
  world_ = make_world_();
  ++generation_;
  ++changes_;
  const std::size_t first = index_.count_until(later(at_, -parameters_.heard_before));
  const std::size_t first_picture = index_.count_until(later(at_, -parameters_.pictures_before));
  const std::vector<std::size_t> newest = index_.newest_of(heard_);
  // What was said last before the stretch that is heard anew, and the last picture wherever it is.
  for (const std::size_t event : newest) {
    if (event < (is_picture(event) ? first_picture : first)) hear(event);
  }
  for (std::size_t event = first; event < heard_; ++event) {
    if (event >= first_picture || !is_picture(event)) hear(event);
  }
  world_->advance(at_, seconds(at_));
}

void LogShown::step(int frames) {
  const std::vector<std::size_t>& pictures = index_.pictures();
  if (pictures.empty()) return;
  const std::shared_ptr<const Frame> shown = picture();
  std::ptrdiff_t number = -1;  // of the picture shown; -1: before the first
  if (shown) {
    const auto at_frame =
        std::lower_bound(pictures.begin(), pictures.end(), shown->at,
                         [this](std::size_t event, std::int64_t at) { return index_.events()[event].at < at; });
    number = at_frame - pictures.begin();
  }
  const auto last = static_cast<std::ptrdiff_t>(pictures.size()) - 1;
  show_picture(static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(number + frames, 0, last)));
}

void LogShown::advance(double now) {
  const double passed = advanced_at_ ? std::min(now - *advanced_at_, parameters_.longest_step) : 0.0;
  advanced_at_ = now;
  fulfil();
  if (!playing_) return;
  stepped_to_.reset();
  const std::int64_t end = later(index_.end(), parameters_.patience);
  at_ = std::min(later(at_, speed_ * passed), end);
  if (at_ == end) playing_ = false;
  const std::size_t until = index_.count_until(at_);
  const std::size_t first_picture = index_.count_until(later(at_, -parameters_.pictures_before));
  for (; heard_ < until; ++heard_) {
    if (heard_ >= first_picture || !is_picture(heard_)) hear(heard_);
  }
  world_->advance(at_, seconds(at_));
  ++changes_;
}

VersionedText LogShown::play() {
  fulfil();
  return {changes_, fmt::format("{{\"utime\":\"{}\",\"playing\":{},\"speed\":{}}}", at_, playing_, speed_)};
}

std::string LogShown::control(const ClientWord& message) {
  if (const auto* play = std::get_if<ClientPlay>(&message)) {
    if (utime() >= index_.end()) wish_ = {index_.begin(), 0};
    playing_ = true;
    speed_ = play->speed;
  } else if (std::holds_alternative<ClientPause>(message)) {
    playing_ = false;
  } else if (const auto* wanted = std::get_if<ClientSeek>(&message)) {
    wish_ = {wanted->utime, 0};
  } else if (const auto* wished = std::get_if<ClientStep>(&message)) {
    playing_ = false;
    wish_.frames = std::clamp(wish_.frames + wished->frames, -kMostSteps, kMostSteps);
  }
  ++changes_;
  return {};
}

}  // namespace markservo::mmi
