#include "common/logs/log_format.hpp"

#include <algorithm>
#include <array>

namespace markservo::logs {
namespace {

std::uint64_t big_endian(const std::uint8_t* bytes, int size) {
  std::uint64_t number = 0;
  for (int i = 0; i < size; ++i) number = number << 8 | bytes[i];
  return number;
}

std::int64_t size_field(const std::uint8_t* bytes) {
  return static_cast<std::int32_t>(big_endian(bytes, 4));
}

void append(std::string& text, std::uint64_t number, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) text += static_cast<char>(number >> shift & 0xff);
}

}  // namespace

std::optional<Header> header_at(ByteView log, std::size_t offset) {
  if (offset > log.size || log.size - offset < kHeaderSize) return std::nullopt;
  const std::uint8_t* bytes = log.data + offset;
  Header header;
  header.sync = big_endian(bytes, 4) == kSyncWord;
  header.number = static_cast<std::int64_t>(big_endian(bytes + 4, 8));
  header.utime = static_cast<std::int64_t>(big_endian(bytes + 12, 8));
  header.channel_size = size_field(bytes + 20);
  header.data_size = size_field(bytes + 24);
  return header;
}

bool sync_at(ByteView log, std::size_t offset) {
  return offset <= log.size && log.size - offset >= kSyncSize && big_endian(log.data + offset, 4) == kSyncWord;
}

std::size_t next_sync(ByteView log, std::size_t offset) {
  static constexpr std::array<std::uint8_t, kSyncSize> kSync = {0xED, 0xA1, 0xDA, 0x01};
  if (offset >= log.size) return log.size;
  const std::uint8_t* end = log.data + log.size;
  return static_cast<std::size_t>(std::search(log.data + offset, end, kSync.begin(), kSync.end()) - log.data);
}

LogEvent event_at(ByteView log, std::size_t offset, const Header& header, std::size_t data_size) {
  const auto channel_size = static_cast<std::size_t>(header.channel_size);
  const ByteView channel{log.data + offset + kHeaderSize, channel_size};
  return {header.number, header.utime, channel.text(), {channel.data + channel_size, data_size}};
}

std::string encoded(const LogEvent& event) {
  std::string bytes;
  bytes.reserve(kHeaderSize + event.channel.size() + event.data.size);
  append(bytes, kSyncWord, 4);
  append(bytes, static_cast<std::uint64_t>(event.number), 8);
  append(bytes, static_cast<std::uint64_t>(event.utime), 8);
  append(bytes, event.channel.size(), 4);
  append(bytes, event.data.size, 4);
  bytes += event.channel;
  bytes += event.data.text();
  return bytes;
}

}  // namespace markservo::logs
