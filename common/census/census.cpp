#include "common/census/census.hpp"

#include <algorithm>
#include <markservo/channels.hpp>

namespace markservo::census {
namespace {

constexpr double kSeconds = 1e-6;  // in a microsecond

std::string last_part(const std::string& channel) {
  const std::size_t slash = channel.rfind('/');
  return slash == std::string::npos ? channel : channel.substr(slash + 1);
}

// Between the first and the last event where there are enough of them, else over the whole span.
double rate(int64_t events, int64_t first_us, int64_t last_us, double listened_s) {
  constexpr int64_t kEnough = 3;
  if (events >= kEnough && last_us > first_us) {
    return static_cast<double>(events - 1) / (kSeconds * static_cast<double>(last_us - first_us));
  }
  return listened_s > 0.0 ? static_cast<double>(events) / listened_s : 0.0;
}

}  // namespace

bool is_ready(const std::string& state) {
  return state != "starting" && state != "waiting" && state != "stale";
}

std::string robot_of(const std::string& channel) {
  const std::size_t slash = channel.rfind('/');
  return slash == std::string::npos ? std::string() : channel.substr(0, slash);
}

bool is_for_many(const std::string& channel) {
  const std::string name = last_part(channel);
  const channels::Entry* entry = channels::find(name);
  return entry != nullptr && entry->second == channels::Second::kAllowed;
}

void Census::hear(const Heard& message) {
  if (channels_.size() >= kMaxChannels && channels_.count(message.channel) == 0) return;
  ChannelTally& tally = channels_[message.channel];
  if (tally.events == 0) tally.first_us = message.utime;
  if (tally.events > 0 && tally.hash != message.hash) tally.several_types = true;
  ++tally.events;
  tally.bytes += message.bytes;
  tally.last_us = message.utime;
  tally.hash = message.hash;
  tally.type = message.type;
  if (!message.session) return;
  if (tally.writers.size() < kMaxWriters || tally.writers.count(*message.session) > 0)
    ++tally.writers[*message.session];
  // Of a type without seq only the sessions count.
  tally.sequence.observe(*message.session, message.seq.value_or(0));
}

void Census::hear(const ServiceWord& word, int64_t utime) {
  const Process process{word.robot, word.name, word.host, word.pid, word.session};
  if (services_.size() >= kMaxServices && services_.count(process) == 0) return;
  ServiceTally& tally = services_[process];
  const int64_t behind = utime - word.utime;
  tally.behind_us = tally.heard == 0 ? behind : std::min(tally.behind_us, behind);
  tally.newest = word;
  tally.last_us = utime;
  ++tally.heard;
  names_[Name{word.robot, word.name}].observe(word.session, 0);
}

// A service that was restarted speaks with a new session and never again with the old one.
bool Census::is_duplicate(const ServiceTally& tally) const {
  if (tally.newest.name == kStackWatch) return false;
  const auto name = names_.find(Name{tally.newest.robot, tally.newest.name});
  return name != names_.end() && name->second.second_writer();
}

Report Census::report(int64_t utime) const {
  Report report;
  report.listened_s = kSeconds * static_cast<double>(utime - begin_us_);
  std::map<int64_t, std::string> names;
  for (const auto& [process, tally] : services_) names[tally.newest.session] = tally.newest.name;
  std::map<int64_t, std::vector<std::string>> written;
  for (const auto& [channel, tally] : channels_) {
    ChannelReport line;
    line.channel = channel;
    line.type = tally.type;
    line.hash = tally.hash;
    line.events = tally.events;
    line.hz = rate(tally.events, tally.first_us, tally.last_us, report.listened_s);
    line.bytes_per_s = line.hz * static_cast<double>(tally.bytes) / static_cast<double>(tally.events);
    line.several_types = tally.several_types;
    if (!is_for_many(channel)) {
      line.lost = tally.sequence.lost();
      line.two_writers = tally.sequence.second_writer();
    }
    for (const auto& [session, events] : tally.writers) {
      const auto name = names.find(session);
      line.writers.push_back({session, name == names.end() ? std::string() : name->second, events});
      if (last_part(channel) != channels::kServiceStatus.name) written[session].push_back(channel);
    }
    report.channels.push_back(std::move(line));
  }
  for (const auto& [process, tally] : services_) {
    ServiceReport line;
    line.newest = tally.newest;
    line.heard = tally.heard;
    line.silent_s = kSeconds * static_cast<double>(utime - tally.last_us);
    line.clock_behind_s = kSeconds * static_cast<double>(tally.behind_us);
    line.duplicate = is_duplicate(tally);
    const auto channels = written.find(tally.newest.session);
    if (channels != written.end()) line.writes = channels->second;
    report.services.push_back(std::move(line));
  }
  return report;
}

}  // namespace markservo::census
