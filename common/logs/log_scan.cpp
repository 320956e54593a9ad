#include "common/logs/log_scan.hpp"

#include <algorithm>
#include <optional>

#include "common/logs/bus_limits.hpp"
#include "common/logs/log_format.hpp"

namespace markservo::logs {
namespace {

bool readable(std::string_view channel) {
  return std::all_of(channel.begin(), channel.end(), [](char character) {
    const auto code = static_cast<unsigned char>(character);
    return code >= 0x20 && code != 0x7f;
  });
}

class Scanner {
 public:
  Scanner(ByteView log, const FitCheck& fit) : log_(log), fit_(fit) {}

  Scan run() {
    std::size_t at = 0;
    while (at < log_.size) at = step(at);
    return std::move(result_);
  }

 private:
  // Takes what stands at `at`; returns where to go on.
  std::size_t step(std::size_t at) {
    const std::optional<Header> header = header_at(log_, at);
    if (header && header->sync && header->possible()) {
      const std::size_t end = end_of(at, *header);
      if (end <= log_.size && boundary(end)) return keep(at, *header, end);
      return mend(at, *header, end);
    }
    if (header && lost_its_sync(at, *header)) {
      // Damage as long as the sync word: the event itself is whole.
      note_damage(at, kSyncSize);
      return keep(at, *header, end_of(at, *header));
    }
    const std::size_t next = next_event(at + 1);
    note_damage(at, next - at);
    return next;
  }

  // An event that no other event follows directly: its own size is wrong, or what follows is damaged.
  std::size_t mend(std::size_t at, const Header& header, std::size_t end) {
    const std::size_t next = next_event(at + kSyncSize);
    const std::size_t begin_of_data = at + kHeaderSize + static_cast<std::size_t>(header.channel_size);
    const bool may_be_whole = end <= next;
    const bool may_reach_next = begin_of_data <= next;
    const auto data_to_next = static_cast<std::int64_t>(next) - static_cast<std::int64_t>(begin_of_data);
    if (may_be_whole && fit_of(at, header, end) == Fit::kFits) return keep(at, header, end);
    if (may_reach_next && fit_of(at, header, next) == Fit::kFits) return keep(at, header, next);
    const bool unknown = may_reach_next && fit_of(at, header, next) == Fit::kUnknownType;
    if (unknown && one_bit_apart(header.data_size, data_to_next)) return keep(at, header, next);
    if (unknown && may_be_whole) return keep(at, header, end);
    note_damage(at, next - at);
    return next;
  }

  // A header whose sync word alone is wrong: an event with a name for its channel that ends where another begins.
  bool lost_its_sync(std::size_t at, const Header& header) const {
    if (!plausible(at, header)) return false;
    const std::size_t end = end_of(at, header);
    return end < log_.size && boundary(end);
  }

  bool plausible(std::size_t at, const Header& header) const {
    if (!header.possible() || header.channel_size > static_cast<std::int64_t>(kLongestLcmChannel)) return false;
    const auto size = static_cast<std::size_t>(header.channel_size);
    return size <= log_.size - at - kHeaderSize && readable(event_at(log_, at, header, 0).channel);
  }

  // Where the next event begins, at or after `from`; the log's size when there is none.
  std::size_t next_event(std::size_t from) const {
    for (std::size_t at = next_sync(log_, from); at < log_.size; at = next_sync(log_, at + 1)) {
      const std::optional<Header> header = header_at(log_, at);
      if (header && plausible(at, *header)) return at;
    }
    return log_.size;
  }

  bool boundary(std::size_t at) const { return at == log_.size || sync_at(log_, at); }

  static std::size_t end_of(std::size_t at, const Header& header) {
    return at + kHeaderSize + static_cast<std::size_t>(header.channel_size + header.data_size);
  }

  static bool one_bit_apart(std::int64_t a, std::int64_t b) {
    const auto difference = static_cast<std::uint64_t>(a ^ b);
    return difference != 0 && (difference & (difference - 1)) == 0;
  }

  LogEvent event_to(std::size_t at, const Header& header, std::size_t end) const {
    return event_at(log_, at, header, end - at - kHeaderSize - static_cast<std::size_t>(header.channel_size));
  }

  Fit fit_of(std::size_t at, const Header& header, std::size_t end) const {
    return fit_(event_to(at, header, end).data);
  }

  std::size_t keep(std::size_t at, const Header& header, std::size_t end) {
    result_.events.push_back(event_to(at, header, end));
    return end;
  }

  void note_damage(std::size_t at, std::size_t bytes) {
    std::vector<Damage>& damage = result_.damage;
    if (!damage.empty() && damage.back().offset + damage.back().bytes == at) {
      damage.back().bytes += bytes;
    } else {
      damage.push_back({at, bytes});
    }
  }

  ByteView log_;
  const FitCheck& fit_;
  Scan result_;
};

}  // namespace

Scan scan(ByteView log, const FitCheck& fit) {
  return Scanner(log, fit).run();
}

}  // namespace markservo::logs
