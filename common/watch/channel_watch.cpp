#include "common/watch/channel_watch.hpp"

#include <algorithm>

namespace markservo::watch {
namespace {

constexpr std::size_t kMaxArrivals = 4096;  // in the window; a flood's rate is told by its last ones
constexpr std::size_t kMaxWriters = 64;

}  // namespace

void ChannelWatch::observe(const reflection::MessageNote& note, double now) {
  newest_ = note;
  ++received_;
  bytes_ += static_cast<std::int64_t>(note.bytes);
  if (!note.decodes) ++undecodable_;
  arrivals_.push_back({now, note.bytes});
  while (arrivals_.size() > kMaxArrivals || arrivals_.front().time < now - parameters_.window) arrivals_.pop_front();
  const auto intervals = static_cast<double>(arrivals_.size() - 1);
  if (intervals > 0.0) interval_ = (now - arrivals_.front().time) / intervals;
  if (note.session != 0) follow(note.session, note.seq, now);
}

void ChannelWatch::follow(std::int64_t session, std::int64_t seq, double now) {
  const auto known = writers_.find(session);
  if (seq >= 0 && !lost_) lost_ = 0;
  if (known == writers_.end()) {
    if (writers_.size() >= kMaxWriters) {
      writers_.erase(std::min_element(writers_.begin(), writers_.end(), [](const auto& one, const auto& other) {
        return one.second.heard < other.second.heard;
      }));
    }
    ++sessions_;
  }
  Writer& writer = writers_[session];
  writer.heard = now;
  const std::int64_t missing = writer.gaps.observe(seq);
  if (lost_) lost_ = std::min(*lost_ + missing, bus::kMaxLost);
}

ChannelFigures ChannelWatch::figures(double now) const {
  ChannelFigures figures;
  figures.type = newest_.type;
  figures.fingerprint = newest_.fingerprint;
  figures.received = received_;
  figures.bytes = bytes_;
  figures.newest_bytes = newest_.bytes;
  figures.age = std::max(0.0, now - arrivals_.back().time);
  figures.stale = figures.age > std::max(parameters_.silence, parameters_.missed_intervals * interval_);
  figures.lost = lost_;
  figures.undecodable = undecodable_;
  figures.sessions = sessions_;
  for (const auto& [session, writer] : writers_) {
    if (writer.heard >= now - parameters_.window) ++figures.writers;
  }

  const auto first = std::find_if(arrivals_.begin(), arrivals_.end(),
                                  [&](const Arrival& arrival) { return arrival.time >= now - parameters_.window; });
  if (arrivals_.end() - first < 2 || arrivals_.back().time <= first->time) return figures;
  const double seconds = arrivals_.back().time - first->time;
  double bytes = 0.0;
  for (auto arrival = first + 1; arrival != arrivals_.end(); ++arrival) bytes += static_cast<double>(arrival->bytes);
  figures.hz = static_cast<double>(arrivals_.end() - first - 1) / seconds;
  figures.bytes_per_second = bytes / seconds;
  return figures;
}

}  // namespace markservo::watch
