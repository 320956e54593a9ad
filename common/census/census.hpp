#pragma once

// Who is on the bus: bookkeeping of what was heard in a span of time. No bus, no clock: the caller tells what came and
// when.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/bus/sequence_monitor.hpp"

namespace markservo::census {

// A message on a channel of ours whose type this build does not know: another version of the channel's own.
struct OtherVersion {
  std::string type;           // ours
  std::int64_t our_hash = 0;  // its fingerprint here
  std::int64_t session = 0;   // of the writer, which stands in every version (lcmtypes/README.md); 0: not told
};

// One message as it came off the bus.
struct Heard {
  std::string channel;
  std::int64_t hash = 0;  // the type's fingerprint
  std::string type;       // its name; empty when unknown
  std::int64_t bytes = 0;
  std::int64_t utime = 0;  // us, this host's wall clock when it came
  std::optional<std::int64_t>
      session;  // of the writer; nothing when the type has none or the message cannot be decoded
  std::optional<std::int64_t> seq;
  std::optional<OtherVersion> other_version;
};

// What a service says of one channel that it reads; ChannelStatus.lcm defines each figure.
struct ChannelWord {
  std::string channel;
  std::int64_t received = 0;
  std::int64_t skipped = 0;
  std::int64_t lost = 0;
  std::int64_t decode_failures = 0;
  std::int64_t refused = 0;
  bool second_writer = false;
  double age = -1.0;         // s
  double latency_p50 = 0.0;  // s
  double latency_p99 = 0.0;  // s
};

// One SERVICE_STATUS.
struct ServiceWord {
  std::string robot;  // the channel's prefix; empty when it has none
  std::string name;
  std::string host;
  int pid = 0;
  std::int64_t session = 0;
  std::string version;
  std::int64_t config_hash = 0;
  std::string state;
  std::string reason;
  std::int64_t utime = 0;  // us, its host's wall clock
  std::vector<ChannelWord> channels;
};

// The service that watches over a stack: each stack on a bus has its own.
inline constexpr const char* kStackWatch = "stack-watch";

// Whether a service in this state does its work: it has started and waits for no input.
bool is_ready(const std::string& state);

// The prefix of a channel without its last slash, "r1" of "r1/STOP"; empty when it has none.
std::string robot_of(const std::string& channel);

// Whether more than one may write the channel by design, of any robot, as the table of channels says.
bool is_for_many(const std::string& channel);

struct ServiceReport {
  ServiceWord newest;
  std::int64_t heard = 0;           // SERVICE_STATUS messages
  double silent_s = 0.0;            // since the newest
  double clock_behind_s = 0.0;      // this host's clock minus the service's: the least that was seen, so with the least
                                    // delay on the way; negative when the service's clock is ahead
  bool duplicate = false;           // another process of the same robot and name speaks in turn with it
  std::vector<std::string> writes;  // channels, SERVICE_STATUS apart
};

struct WriterReport {
  std::int64_t session = 0;
  std::string service;  // its name; empty when no SERVICE_STATUS of that session was heard
  std::int64_t events = 0;
};

// Who writes another version of the channel's type.
struct OtherWriterReport {
  std::string type;  // ours
  std::int64_t our_hash = 0;
  std::int64_t hash = 0;  // theirs
  std::int64_t session = 0;
  std::string service;  // its name; empty when no SERVICE_STATUS of that session was heard
  std::int64_t events = 0;
};

struct ChannelReport {
  std::string channel;
  std::string type;
  std::int64_t hash = 0;  // of the newest message
  std::int64_t events = 0;
  double hz = 0.0;
  double bytes_per_s = 0.0;
  std::int64_t lost = 0;  // gaps in seq
  bool several_types = false;
  bool two_writers = false;  // two sessions write in turn where only one may
  std::vector<WriterReport> writers;
  std::vector<OtherWriterReport> other_versions;
};

struct Report {
  double listened_s = 0.0;
  std::vector<ServiceReport> services;  // by robot, name, host and pid
  std::vector<ChannelReport> channels;  // by name
};

// Processes of one host that are known to run, by name and pid: their supervisor says so.
struct KnownProcesses {
  std::string host;
  std::set<std::pair<std::string, int>> processes;

  bool have(const ServiceWord& word) const { return word.host == host && processes.count({word.name, word.pid}) > 0; }
};

class Census {
 public:
  // `utime`: us, when listening began by this host's wall clock; what came before is not counted.
  explicit Census(std::int64_t utime) : begin_us_(utime) {}

  void observe(const Heard& message);
  // From now on these are known: what they say and write finds room whatever others send under other names, and where
  // two processes claim one session it is theirs.
  void observe(const KnownProcesses& known);
  // A SERVICE_STATUS; the same message goes to observe(Heard) too. `utime`: us, when it came.
  void observe(const ServiceWord& word, std::int64_t utime);

  // `utime`: us, when listening ended.
  Report report(std::int64_t utime) const;

 private:
  // More are not kept apart: a hostile writer must not take all memory.
  // Bus-wide each: a hundred robots have 2,000 channels, 900 services and 7,000 channels told of.
  static constexpr std::size_t kMaxChannels = 4096;
  static constexpr std::size_t kMaxServices = 1024;
  static constexpr std::size_t kMaxChannelWords = 16384;
  static constexpr std::size_t kMaxWriters = 16384;
  static constexpr std::size_t kMaxWritersOfOne = 64;  // of one channel
  static constexpr std::size_t kMaxOtherVersions = 8;  // told of, of one channel
  // So much more where one that is known speaks or writes.
  static constexpr std::size_t kShareOfKnown = 4;  // a quarter

  // Whether there is room for one more where `size` are.
  static constexpr bool has_room(std::size_t size, std::size_t most, bool known) {
    return size < most + (known ? most / kShareOfKnown : 0);
  }

  struct ChannelTally {
    std::int64_t events = 0;
    std::int64_t bytes = 0;
    std::int64_t first_us = 0;
    std::int64_t last_us = 0;
    std::int64_t hash = 0;
    bool several_types = false;
    std::string type;
    std::map<std::int64_t, std::int64_t> writers;  // events by session
    std::vector<OtherWriterReport> other_versions;
    bus::SequenceMonitor sequence;
  };
  struct ServiceTally {
    ServiceWord newest;
    std::int64_t heard = 0;
    std::int64_t last_us = 0;
    std::int64_t behind_us = 0;
  };
  using Name = std::pair<std::string, std::string>;                                      // robot, name
  using Process = std::tuple<std::string, std::string, std::string, int, std::int64_t>;  // and host, pid, session

  bool is_duplicate(const ServiceTally& tally) const;
  // The process that each session belongs to.
  std::map<std::int64_t, const ServiceTally*> owners() const;
  void note_writer(ChannelTally* tally, std::int64_t session);
  static void note_other_version(ChannelTally* tally, const Heard& message);

  std::int64_t begin_us_;
  std::map<std::string, ChannelTally> channels_;
  std::map<Process, ServiceTally> services_;
  std::map<Name, bus::SequenceMonitor> names_;
  KnownProcesses known_;
  std::set<std::int64_t> known_sessions_;  // of theirs
  std::size_t writers_ = 0;                // of all channels
  std::size_t channel_words_ = 0;          // of all services
};

}  // namespace markservo::census
