#include "services/log-tool/channel_statistics.hpp"

#include <algorithm>
#include <utility>

#include "common/bus/gap_counter.hpp"
#include "common/logs/bus_limits.hpp"
#include "common/logs/log_event.hpp"

namespace markservo::log_tool {
namespace {

using reflection::DecodedMessage;
using reflection::Field;
using reflection::integer_in;
using reflection::Kind;
using reflection::MessageType;

struct SessionRecord {
  bus::GapCounter gaps;
  std::int64_t utime = 0;
};

class ChannelStatistics {
 public:
  ChannelStatistics(std::string channel, const reflection::TypeCatalog& catalog) : catalog_(catalog) {
    summary_.channel = std::move(channel);
  }

  void add(const logs::LogEvent& event) {
    note_time(event.utime);
    ++summary_.events;
    const auto size = static_cast<std::int64_t>(event.data.size);
    summary_.bytes += size;
    summary_.largest = std::max(summary_.largest, size);
    if (event.data.size > logs::kLargestByUdp) ++summary_.too_large;
    std::uint64_t fingerprint = 0;
    if (!reflection::read_fingerprint(event.data.data, event.data.size, &fingerprint)) {
      ++summary_.undecodable;
      return;
    }
    const bool known = catalog_.find(fingerprint) != nullptr;
    // The first known type is the channel's: one damaged fingerprint must not make all others strangers.
    if (with_type_ == 0 || (summary_.type.empty() && known)) {
      note_type(fingerprint);
      summary_.other_types = with_type_;
    } else if (fingerprint != summary_.fingerprint) {
      ++summary_.other_types;
    }
    ++with_type_;
    if (!known) return;
    const DecodedMessage message = reflection::decode(catalog_, event.data.data, event.data.size);
    if (!message.error.empty()) {
      ++summary_.undecodable;
    } else if (fingerprint == summary_.fingerprint && summary_.lost) {
      note_sequence(message.fields);
    }
  }

  ChannelSummary summary() const { return summary_; }

 private:
  void note_time(std::int64_t utime) {
    if (summary_.events == 0) summary_.first_utime = summary_.last_utime = newest_ = utime;
    summary_.longest_gap = std::max(summary_.longest_gap, logs::seconds_apart(newest_, utime));
    newest_ = utime;
    summary_.first_utime = std::min(summary_.first_utime, utime);
    summary_.last_utime = std::max(summary_.last_utime, utime);
  }

  void note_type(std::uint64_t fingerprint) {
    summary_.fingerprint = fingerprint;
    const MessageType* type = catalog_.find(fingerprint);
    if (type == nullptr) return;
    summary_.type = reflection::shown_name(*type);
    const auto has = [type](const char* name) {
      return std::any_of(type->fields.begin(), type->fields.end(), [name](const Field& field) {
        return field.name == name && field.kind == Kind::kInt64 && field.dimensions.empty();
      });
    };
    if (has("session") && has("seq")) summary_.lost = 0;
  }

  // Each session on its own: several writers of one channel are no loss.
  void note_sequence(const reflection::Fields& fields) {
    const std::int64_t seq = integer_in(fields, "seq", 0);
    const std::int64_t utime = integer_in(fields, "utime", 0);
    const auto [found, first] = sessions_.try_emplace(integer_in(fields, "session", 0));
    SessionRecord& record = found->second;
    if (first) ++summary_.sessions;
    if (!first && utime < record.utime) ++summary_.time_reversals;
    record.utime = utime;
    summary_.lost = std::min(*summary_.lost + record.gaps.observe(seq), bus::kMaxLost);
  }

  const reflection::TypeCatalog& catalog_;
  ChannelSummary summary_;
  std::int64_t with_type_ = 0;  // messages long enough to have one
  std::int64_t newest_ = 0;
  std::map<std::int64_t, SessionRecord> sessions_;
};

}  // namespace

double ChannelSummary::hz() const {
  const double span = logs::seconds_apart(first_utime, last_utime);
  return events > 1 && span > 0.0 ? static_cast<double>(events - 1) / span : 0.0;
}

double LogSummary::seconds() const {
  return logs::seconds_apart(first_utime, last_utime);
}

std::int64_t LogSummary::undecodable() const {
  std::int64_t sum = 0;
  for (const ChannelSummary& channel : channels) sum += channel.undecodable;
  return sum;
}

LogSummary summarise(const std::vector<logs::LogEvent>& events, const reflection::TypeCatalog& catalog) {
  LogSummary summary;
  summary.steps = time_steps(events);
  std::map<std::string, ChannelStatistics, std::less<>> channels;
  for (const logs::LogEvent& event : events) {
    if (summary.events == 0) summary.first_utime = summary.last_utime = event.utime;
    summary.first_utime = std::min(summary.first_utime, event.utime);
    summary.last_utime = std::max(summary.last_utime, event.utime);
    ++summary.events;
    auto channel = channels.find(event.channel);
    if (channel == channels.end()) {
      const std::string name(event.channel);
      channel = channels.emplace(name, ChannelStatistics(name, catalog)).first;
    }
    channel->second.add(event);
  }
  for (const auto& entry : channels) summary.channels.push_back(entry.second.summary());
  return summary;
}

}  // namespace markservo::log_tool
