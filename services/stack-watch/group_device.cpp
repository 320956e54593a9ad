#include "services/stack-watch/group_device.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <thread>

#include "common/bus/bus_url.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::stack_watch {
namespace {

int whole_number(const std::string& url, const std::string& text, int most) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0 || value > most) {
    throw ConfigurationError("bus " + url + ": '" + text + "'; allowed: 0 to " + std::to_string(most));
  }
  return value;
}

sockaddr_in internet_address(const std::string& group, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, group.c_str(), &address.sin_addr);
  return address;
}

std::string text_of(const sockaddr_in& address) {
  std::string text(INET_ADDRSTRLEN, '\0');
  inet_ntop(AF_INET, &address.sin_addr, text.data(), INET_ADDRSTRLEN);
  text.resize(std::strlen(text.c_str()));
  return text + ":" + std::to_string(ntohs(address.sin_port));
}

// Sets an option of the socket; false where the kernel refuses.
template <class T>
bool set(int descriptor, int level, int option, const T& value) {
  return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

}  // namespace

GroupAddress group_address(const std::string& url) {
  constexpr int kMostBytes = 1 << 30;
  if (!bus::is_udpm(url)) throw ConfigurationError("bus " + url + ": allowed is udpm://, a bus that others write on");
  GroupAddress address;
  std::string rest = url.substr(std::strlen("udpm://"));
  std::string options;
  if (const auto mark = rest.find('?'); mark != std::string::npos) {
    options = rest.substr(mark + 1) + "&";
    rest.resize(mark);
  }
  if (const auto colon = rest.find(':'); colon != std::string::npos) {
    address.port = whole_number(url, rest.substr(colon + 1), 65535);
    rest.resize(colon);
  }
  if (!rest.empty()) address.group = rest;
  in_addr parsed{};
  if (inet_pton(AF_INET, address.group.c_str(), &parsed) != 1 || !IN_MULTICAST(ntohl(parsed.s_addr))) {
    throw ConfigurationError("bus " + url + ": '" + address.group + "'; allowed: a multicast address");
  }
  for (std::size_t at = 0; at < options.size(); at = options.find('&', at) + 1) {
    const std::string option = options.substr(at, options.find('&', at) - at);
    const std::string value = option.substr(std::min(option.size(), option.find('=') + 1));
    if (option.rfind("ttl=", 0) == 0) address.ttl = whole_number(url, value, 255);
    if (option.rfind("recv_buf_size=", 0) == 0) address.receive_buffer = whole_number(url, value, kMostBytes);
  }
  return address;
}

std::string GroupDevice::open() {
  shut();
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return std::strerror(errno);
  const sockaddr_in group = internet_address(address_.group, address_.port);
  sockaddr_in any = internet_address("0.0.0.0", address_.port);
  ip_mreq membership{};
  membership.imr_multiaddr = group.sin_addr;
  if (address_.receive_buffer > 0) set(descriptor, SOL_SOCKET, SO_RCVBUF, address_.receive_buffer);
  if (!set(descriptor, SOL_SOCKET, SO_REUSEADDR, 1) ||
      bind(descriptor, reinterpret_cast<const sockaddr*>(&any), sizeof any) != 0 ||
      !set(descriptor, IPPROTO_IP, IP_ADD_MEMBERSHIP, membership) ||
      !set(descriptor, IPPROTO_IP, IP_MULTICAST_TTL, static_cast<std::uint8_t>(address_.ttl))) {
    const std::string why = std::strerror(errno);
    close(descriptor);
    return why;
  }
  descriptor_ = descriptor;
  return {};
}

void GroupDevice::shut() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
}

void GroupDevice::poll(std::chrono::milliseconds timeout, const std::function<void(const Datagram&)>& handler) {
  constexpr int kMost = 4096;  // so that a flood cannot keep the caller from its other work
  if (!is_open()) {
    std::this_thread::sleep_for(timeout);
    return;
  }
  pollfd waiting{descriptor_, POLLIN, 0};
  const int ready = ::poll(&waiting, 1, static_cast<int>(timeout.count()));
  // It does not wait where no descriptors are allowed at all.
  if (ready < 0 && errno != EINTR) std::this_thread::sleep_for(timeout);
  if (ready <= 0) return;
  for (int count = 0; count < kMost; ++count) {
    sockaddr_in from{};
    socklen_t from_size = sizeof from;
    const ssize_t size =
        recvfrom(descriptor_, buffer_.data(), buffer_.size(), 0, reinterpret_cast<sockaddr*>(&from), &from_size);
    if (size < 0) return;
    handler({buffer_.data(), static_cast<std::size_t>(size), text_of(from)});
  }
}

bool GroupDevice::send(const std::vector<std::uint8_t>& bytes) const {
  if (!is_open()) return false;
  const sockaddr_in group = internet_address(address_.group, address_.port);
  return sendto(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&group), sizeof group) >=
         0;
}

}  // namespace markservo::stack_watch
