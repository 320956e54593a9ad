#include "tests/system/fault_campaign/multicast_bus.hpp"

#include <arpa/inet.h>
#include <linux/filter.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

namespace markservo::campaign {
namespace {

constexpr const char* kGroup = "239.255.76.67";
constexpr std::uint32_t kShort = 0x4c433032;     // "LC02"
constexpr std::uint32_t kFragment = 0x4c433033;  // "LC03"
constexpr std::size_t kShortHeader = 8;
constexpr std::size_t kFragmentHeader = 20;
constexpr std::size_t kLargestShort = 65'499;  // bytes of channel and message in one datagram
constexpr std::size_t kFragmentSize = 65'000;
constexpr std::size_t kLargestChannel = 63;
constexpr int kReceiveBuffer = 4 << 20;  // bytes

void put(std::vector<std::uint8_t>& bytes, std::uint32_t number, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(number >> shift));
}

std::uint32_t number_at(const std::uint8_t* bytes, int size) {
  std::uint32_t number = 0;
  for (int i = 0; i < size; ++i) number = number << 8 | bytes[i];
  return number;
}

// Fragments but the first are dropped by the kernel: pictures cost the trial nothing.
void drop_later_fragments(int descriptor) {
  constexpr std::uint32_t kUdpHeader = 8;
  std::array<sock_filter, 6> code{{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kUdpHeader),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kFragment, 0, 2),
      BPF_STMT(BPF_LD | BPF_H | BPF_ABS, kUdpHeader + 16),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, 0xffffffff),
      BPF_STMT(BPF_RET | BPF_K, 0),
  }};
  const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  if (setsockopt(descriptor, SOL_SOCKET, SO_ATTACH_FILTER, &program, sizeof program) < 0) {
    throw std::runtime_error("the kernel refuses a socket filter");
  }
}

int open_receiver(const sockaddr_in& group) {
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int yes = 1;
  // The interface is named by its address: where the route is gone for a while, the membership stays.
  const ip_mreq membership{group.sin_addr, {htonl(INADDR_LOOPBACK)}};
  if (descriptor < 0 || setsockopt(descriptor, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) < 0 ||
      setsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &kReceiveBuffer, sizeof kReceiveBuffer) < 0 ||
      bind(descriptor, reinterpret_cast<const sockaddr*>(&group), sizeof group) < 0 ||
      setsockopt(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) < 0) {
    throw std::runtime_error(std::string("the bus cannot be joined: ") + std::strerror(errno) +
                             "; a private network has a loopback interface (scripts/private-network)");
  }
  drop_later_fragments(descriptor);
  return descriptor;
}

}  // namespace

std::vector<std::uint8_t> short_datagram(std::uint32_t sequence, const std::string& channel,
                                         const std::vector<std::uint8_t>& data) {
  std::vector<std::uint8_t> bytes;
  put(bytes, kShort, 4);
  put(bytes, sequence, 4);
  bytes.insert(bytes.end(), channel.c_str(), channel.c_str() + channel.size() + 1);
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

std::vector<std::uint8_t> fragment_datagram(std::uint32_t sequence, std::uint32_t message_size, std::uint32_t offset,
                                            std::uint16_t number, std::uint16_t count, const std::string& channel,
                                            const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  put(bytes, kFragment, 4);
  put(bytes, sequence, 4);
  put(bytes, message_size, 4);
  put(bytes, offset, 4);
  put(bytes, number, 2);
  put(bytes, count, 2);
  if (number == 0) bytes.insert(bytes.end(), channel.c_str(), channel.c_str() + channel.size() + 1);
  bytes.insert(bytes.end(), data, data + size);
  return bytes;
}

HeardMessage parse_datagram(const std::uint8_t* bytes, std::size_t size) {
  HeardMessage message;
  if (size < kShortHeader) return message;
  const std::uint32_t magic = number_at(bytes, 4);
  const bool fragment = magic == kFragment;
  const std::size_t header = fragment ? kFragmentHeader : kShortHeader;
  if ((!fragment && magic != kShort) || size <= header) return message;
  if (fragment && number_at(bytes + 16, 2) != 0) return message;
  const auto* name = reinterpret_cast<const char*>(bytes + header);
  const std::size_t length = strnlen(name, std::min(size - header, kLargestChannel + 1));
  if (length > kLargestChannel || header + length >= size) return message;
  message.channel.assign(name, length);
  message.data = bytes + header + length + 1;
  message.available = size - header - length - 1;
  message.size =
      fragment ? static_cast<std::int64_t>(number_at(bytes + 8, 4)) : static_cast<std::int64_t>(message.available);
  if (fragment) message.available = std::min(message.available, static_cast<std::size_t>(message.size));
  return message;
}

MulticastBus::MulticastBus(std::uint16_t port) : buffer_(1 << 16) {
  group_.sin_family = AF_INET;
  group_.sin_port = htons(port);
  inet_pton(AF_INET, kGroup, &group_.sin_addr);
  receiver_ = open_receiver(group_);
  sender_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const unsigned char ttl = 0;
  if (sender_ < 0 || setsockopt(sender_, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl) < 0) {
    throw std::runtime_error("a socket to send by cannot be made");
  }
}

MulticastBus::~MulticastBus() {
  close(receiver_);
  close(sender_);
}

void MulticastBus::receive(const std::function<void(const HeardMessage&)>& handler) {
  ssize_t size = 0;
  while ((size = recv(receiver_, buffer_.data(), buffer_.size(), MSG_DONTWAIT)) >= 0) {
    const HeardMessage message = parse_datagram(buffer_.data(), static_cast<std::size_t>(size));
    if (!message.channel.empty()) handler(message);
  }
}

bool MulticastBus::send_datagram(const std::vector<std::uint8_t>& bytes) {
  const ssize_t sent =
      sendto(sender_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&group_), sizeof group_);
  if (sent < 0) ++refused_;
  return sent >= 0;
}

bool MulticastBus::send(const std::string& channel, const std::vector<std::uint8_t>& data) {
  const std::uint32_t sequence = sequence_++;
  if (channel.size() + 1 + data.size() <= kLargestShort) return send_datagram(short_datagram(sequence, channel, data));
  const std::size_t count = (data.size() + channel.size() + 1 + kFragmentSize - 1) / kFragmentSize;
  std::size_t offset = 0;
  bool all = true;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t room = kFragmentSize - (i == 0 ? channel.size() + 1 : 0);
    const std::size_t size = std::min(room, data.size() - offset);
    all = send_datagram(fragment_datagram(sequence, static_cast<std::uint32_t>(data.size()),
                                          static_cast<std::uint32_t>(offset), static_cast<std::uint16_t>(i),
                                          static_cast<std::uint16_t>(count), channel, data.data() + offset, size)) &&
          all;
    offset += size;
  }
  return all;
}

}  // namespace markservo::campaign
