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
double rate(std::int64_t events, std::int64_t first_us, std::int64_t last_us, double listened_s) {
  constexpr std::int64_t kEnough = 3;
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

void Census::observe(const Heard& message) {
  const bool known = message.session && known_sessions_.count(*message.session) > 0;
  if (!has_room(channels_.size(), kMaxChannels, known) && channels_.count(message.channel) == 0) return;
  ChannelTally& tally = channels_[message.channel];
  if (tally.events == 0) tally.first_us = message.utime;
  if (tally.events > 0 && tally.hash != message.hash) tally.several_types = true;
  ++tally.events;
  tally.bytes += message.bytes;
  tally.last_us = message.utime;
  tally.hash = message.hash;
  tally.type = message.type;
  if (message.other_version) note_other_version(&tally, message);
  if (!message.session) return;
  note_writer(&tally, *message.session);
  // Of a type without seq only the sessions count.
  tally.sequence.observe(*message.session, message.seq.value_or(0));
}

void Census::note_writer(ChannelTally* tally, std::int64_t session) {
  const auto writer = tally->writers.find(session);
  if (writer != tally->writers.end()) {
    ++writer->second;
    return;
  }
  const bool known = known_sessions_.count(session) > 0;
  if (!has_room(tally->writers.size(), kMaxWritersOfOne, known) || !has_room(writers_, kMaxWriters, known)) return;
  tally->writers[session] = 1;
  ++writers_;
}

void Census::note_other_version(ChannelTally* tally, const Heard& message) {
  const OtherVersion& version = *message.other_version;
  for (OtherWriterReport& writer : tally->other_versions) {
    if (writer.hash != message.hash || writer.session != version.session) continue;
    ++writer.events;
    return;
  }
  if (tally->other_versions.size() >= kMaxOtherVersions) return;
  tally->other_versions.push_back({version.type, version.our_hash, message.hash, version.session, std::string(), 1});
}

void Census::observe(const KnownProcesses& known) {
  known_ = known;
  known_sessions_.clear();
  for (const auto& [process, tally] : services_) {
    if (known_.have(tally.newest)) known_sessions_.insert(tally.newest.session);
  }
}

void Census::observe(const ServiceWord& word, std::int64_t utime) {
  const Process process{word.robot, word.name, word.host, word.pid, word.session};
  const bool known = known_.have(word);
  if (!has_room(services_.size(), kMaxServices, known) && services_.count(process) == 0) return;
  if (known && has_room(known_sessions_.size(), kMaxServices, false)) known_sessions_.insert(word.session);
  ServiceTally& tally = services_[process];
  const std::int64_t behind = utime - word.utime;
  tally.behind_us = tally.heard == 0 ? behind : std::min(tally.behind_us, behind);
  channel_words_ -= tally.newest.channels.size();
  tally.newest = word;
  auto& channels = tally.newest.channels;
  while (!channels.empty() && !has_room(channel_words_ + channels.size() - 1, kMaxChannelWords, known))
    channels.pop_back();
  channels.shrink_to_fit();
  channel_words_ += channels.size();
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

// Where several claim it: the one that is known, or else the one that has said most.
std::map<std::int64_t, const Census::ServiceTally*> Census::owners() const {
  std::map<std::int64_t, const ServiceTally*> owners;
  const auto rank = [this](const ServiceTally& tally) {
    return std::make_pair(known_.have(tally.newest), tally.heard);
  };
  for (const auto& [process, tally] : services_) {
    const ServiceTally*& owner = owners[tally.newest.session];
    if (owner == nullptr || rank(*owner) < rank(tally)) owner = &tally;
  }
  return owners;
}

Report Census::report(std::int64_t utime) const {
  Report report;
  report.listened_s = kSeconds * static_cast<double>(utime - begin_us_);
  const auto owner_of = owners();
  const auto name_of = [&owner_of](std::int64_t session) {
    const auto owner = owner_of.find(session);
    return owner == owner_of.end() ? std::string() : owner->second->newest.name;
  };
  std::map<std::int64_t, std::vector<std::string>> written;
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
      line.writers.push_back({session, name_of(session), events});
      if (last_part(channel) != channels::kServiceStatus.name) written[session].push_back(channel);
    }
    line.other_versions = tally.other_versions;
    for (OtherWriterReport& writer : line.other_versions) writer.service = name_of(writer.session);
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
    if (channels != written.end() && owner_of.at(tally.newest.session) == &tally) line.writes = channels->second;
    report.services.push_back(std::move(line));
  }
  return report;
}

}  // namespace markservo::census
