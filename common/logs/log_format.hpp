#pragma once

// LCM's log format (LCM manual, "LCM Log File Format"): events one after the other, each with a header of 28 bytes, all
// numbers big-endian, then the channel's name and the message.

#include <optional>
#include <string>

#include "common/logs/log_event.hpp"

namespace markservo::logs {

inline constexpr std::uint32_t kSyncWord = 0xEDA1DA01;
inline constexpr std::size_t kSyncSize = 4;
inline constexpr std::size_t kHeaderSize = 28;
inline constexpr std::size_t kLongestChannel = 999;  // what lcm::LogFile takes

struct Header {
  bool sync = false;
  std::int64_t number = 0;
  std::int64_t utime = 0;  // us
  std::int64_t channel_size = 0;
  std::int64_t data_size = 0;

  // Sizes that lcm::LogFile would take.
  bool possible() const {
    return channel_size > 0 && channel_size <= static_cast<std::int64_t>(kLongestChannel) && data_size >= 0;
  }
};

// The header at `offset`; nothing where fewer than kHeaderSize bytes are left.
std::optional<Header> header_at(ByteView log, std::size_t offset);

bool sync_at(ByteView log, std::size_t offset);

// The next sync word at or after `offset`, or the log's size.
std::size_t next_sync(ByteView log, std::size_t offset);

// The event at `offset` with a message of `data_size` bytes; all of it must lie within the log.
LogEvent event_at(ByteView log, std::size_t offset, const Header& header, std::size_t data_size);

// The event as a log holds it.
std::string encoded(const LogEvent& event);

}  // namespace markservo::logs
