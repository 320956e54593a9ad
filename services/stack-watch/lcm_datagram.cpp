#include "services/stack-watch/lcm_datagram.hpp"

#include <algorithm>

namespace markservo::stack_watch {
namespace {

constexpr std::uint32_t kShort = 0x4c433032;     // "LC02"
constexpr std::uint32_t kFragment = 0x4c433033;  // "LC03"
constexpr std::size_t kShortHeader = 8;          // bytes
constexpr std::size_t kFragmentHeader = 20;
constexpr std::size_t kMaxChannel = 63;  // characters, as in liblcm

// The big-endian number of `bytes` bytes at `at`.
std::uint32_t number(const std::uint8_t* at, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i) value = value << 8 | at[i];
  return value;
}

void append(std::vector<std::uint8_t>* bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes->push_back(static_cast<std::uint8_t>(value >> shift));
}

// Where the channel's name that begins at `begin` ends; null when it does not, or is longer than liblcm takes.
const std::uint8_t* end_of_channel(const std::uint8_t* begin, const std::uint8_t* end) {
  const std::uint8_t* zero = std::find(begin, end, 0);
  return zero == end || static_cast<std::size_t>(zero - begin) > kMaxChannel ? nullptr : zero;
}

}  // namespace

std::optional<LcmDatagram> read_datagram(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  const std::uint8_t* end = bytes + size;
  if (size < kShortHeader) return std::nullopt;
  const std::uint32_t kind = number(bytes, 4);
  const bool fragment = kind == kFragment;
  if (!fragment && kind != kShort) return std::nullopt;
  if (fragment && (size < kFragmentHeader || number(bytes + 16, 2) != 0)) return std::nullopt;
  const std::uint8_t* name = bytes + (fragment ? kFragmentHeader : kShortHeader);
  const std::uint8_t* zero = end_of_channel(name, end);
  if (zero == nullptr) return std::nullopt;
  LcmDatagram datagram;
  datagram.channel.assign(name, zero);
  datagram.payload = zero + 1;
  datagram.size = static_cast<std::size_t>(end - datagram.payload);
  datagram.message_size = fragment ? number(bytes + 8, 4) : datagram.size;
  datagram.whole = !fragment;
  return datagram;
}

bool is_crafted(const void* data, std::size_t size, std::size_t datagram_size) {
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  if (size < kFragmentHeader || number(bytes, 4) != kFragment) return false;
  std::uint64_t part = datagram_size - kFragmentHeader;
  if (number(bytes + 16, 2) == 0) {
    const std::uint8_t* zero = end_of_channel(bytes + kFragmentHeader, bytes + size);
    if (zero == nullptr) return true;
    part -= static_cast<std::uint64_t>(zero + 1 - (bytes + kFragmentHeader));
  }
  return std::uint64_t{number(bytes + 12, 4)} + part > number(bytes + 8, 4);
}

std::vector<std::uint8_t> short_message(std::uint32_t message_number, const std::string& channel,
                                        const std::vector<std::uint8_t>& payload) {
  std::vector<std::uint8_t> bytes;
  append(&bytes, kShort);
  append(&bytes, message_number);
  bytes.insert(bytes.end(), channel.begin(), channel.end());
  bytes.push_back(0);
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
}

}  // namespace markservo::stack_watch
