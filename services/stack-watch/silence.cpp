#include "services/stack-watch/silence.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::stack_watch {

void SilenceWatch::observe_word(const std::string& name, int pid, std::int64_t session, std::int64_t now_us) {
  const Key key{name, pid};
  const auto found = speakers_.find(key);
  if (found == speakers_.end()) return;
  Speaker& speaker = found->second;
  if (speaker.session != session) {
    speaker_of_.erase(speaker.session);
    speaker.session = session;
    speaker_of_[session] = key;
  }
  speaker.spoke = true;
  have_spoken_.insert(name);
  mute_.erase(name);
  renew(key, now_us);
}

void SilenceWatch::observe_session(std::int64_t session, std::int64_t now_us) {
  const auto key = speaker_of_.find(session);
  if (key != speaker_of_.end()) renew(key->second, now_us);
}

void SilenceWatch::renew(const Key& key, std::int64_t now_us) {
  Speaker& speaker = speakers_[key];
  speaker.heard_us = now_us;
  speaker.counted_us = std::max(speaker.counted_us, now_us);
}

void SilenceWatch::send_beacon() {
  if (!beacons_.empty() && !beacons_.back()) ++beacons_in_a_row_missed_;
  beacons_.push_back(false);
  if (beacons_.size() > kBeaconsKept) beacons_.pop_front();
}

void SilenceWatch::observe_beacon(std::int64_t now_us) {
  if (bus_is_gone()) {
    count_anew(now_us + parameters_.return_us);
    beacons_.clear();  // what was missed then was no chance
  } else if (heard_no_beacon_) {
    count_anew(now_us);
  }
  heard_no_beacon_ = false;
  beacons_in_a_row_missed_ = 0;
  if (!beacons_.empty()) beacons_.back() = true;
}

std::vector<SilentService> SilenceWatch::step(const std::vector<RunningProcess>& processes, std::int64_t now_us) {
  follow(processes, now_us);
  if (stepped_us_ >= 0 && now_us - stepped_us_ > parameters_.leap_us) count_anew(now_us);
  stepped_us_ = now_us;
  std::vector<SilentService> silent;
  if (bus_is_gone() || heard_no_beacon_) return silent;
  for (auto& [key, speaker] : speakers_) {
    if (!is_silent(key, speaker, now_us)) continue;
    silent.push_back({key.first, key.second, now_us - speaker.heard_us, speaker.spoke});
    speaker.counted_us = now_us;
  }
  return silent;
}

bool SilenceWatch::is_silent(const Key& key, const Speaker& speaker, std::int64_t now_us) {
  if (speaker.spoke) return now_us - speaker.counted_us >= limit_us();
  int& mute = mute_[key.first];
  const std::int64_t start_us = parameters_.start_us << std::min(mute, parameters_.start_doubled);
  if (now_us - speaker.counted_us < std::max(limit_us(), start_us)) return false;
  if (have_spoken_.count(key.first) == 0 && mute >= parameters_.mute_in_a_row) return false;
  ++mute;
  return true;
}

void SilenceWatch::follow(const std::vector<RunningProcess>& processes, std::int64_t now_us) {
  std::set<Key> running;
  for (const RunningProcess& process : processes) {
    const Key key{process.name, process.pid};
    running.insert(key);
    Speaker& speaker = speakers_.try_emplace(key, Speaker{false, 0, now_us, now_us}).first->second;
    if (!speaker.spoke && !process.must_speak) speaker.heard_us = speaker.counted_us = now_us;
  }
  for (auto speaker = speakers_.begin(); speaker != speakers_.end();) {
    if (running.count(speaker->first) > 0) {
      ++speaker;
      continue;
    }
    speaker_of_.erase(speaker->second.session);
    speaker = speakers_.erase(speaker);
  }
}

std::int64_t SilenceWatch::limit_us() const {
  // The newest may still be on its way.
  const auto known = static_cast<double>(beacons_.empty() ? 0 : beacons_.size() - 1);
  double missed = 0.0;
  for (std::size_t i = 0; i + 1 < beacons_.size(); ++i) missed += beacons_[i] ? 0.0 : 1.0;
  const double share = (missed + 0.5) / (known + 1.0);
  // So many words, one a second, are lost one after another less often than `chance`.
  const double words = std::min(std::log(parameters_.chance) / std::log(std::min(share, 0.95)), 300.0);
  return std::max(parameters_.silence_us, static_cast<std::int64_t>(1e6 * words));
}

std::int64_t SilenceWatch::silent_for_us(const std::string& name, int pid, std::int64_t now_us) const {
  const auto speaker = speakers_.find({name, pid});
  return speaker == speakers_.end() || !speaker->second.spoke ? -1 : now_us - speaker->second.heard_us;
}

void SilenceWatch::count_anew(std::int64_t from_us) {
  for (auto& [key, speaker] : speakers_) speaker.counted_us = std::max(speaker.counted_us, from_us);
}

}  // namespace markservo::stack_watch
