// A slow cable: passes the datagrams of one multicast group on between two network interfaces, each way, some time
// after they came. For tests, where the kernel cannot delay packets itself.
// usage: delay-relay GROUP PORT DELAY_MS ADDRESS_A ADDRESS_B   (of its own two interfaces; runs until it is told to
// end)

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr std::size_t kLargestDatagram = 65536;

void check(int result, const std::string& what) {
  if (result < 0) throw std::runtime_error(what + ": cannot be done");
}

in_addr address_of(const std::string& text) {
  in_addr address{};
  if (inet_pton(AF_INET, text.c_str(), &address) != 1) {
    throw std::runtime_error("'" + text + "'; allowed: an IPv4 address");
  }
  return address;
}

// Hears the group on one interface only, and sends to it there without hearing itself.
int open_end(const sockaddr_in& group, const std::string& interface) {
  const int socket_fd = socket(AF_INET, SOCK_DGRAM, 0);
  check(socket_fd, "a socket");
  const int yes = 1;
  const int no = 0;
  const int ttl = 1;
  const in_addr own = address_of(interface);
  const ip_mreq membership{group.sin_addr, own};
  check(setsockopt(socket_fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes), "sharing the port");
  check(setsockopt(socket_fd, IPPROTO_IP, IP_MULTICAST_ALL, &no, sizeof no), "hearing one interface");
  check(setsockopt(socket_fd, IPPROTO_IP, IP_MULTICAST_LOOP, &no, sizeof no), "not hearing itself");
  check(setsockopt(socket_fd, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl), "ttl 1");
  check(setsockopt(socket_fd, IPPROTO_IP, IP_MULTICAST_IF, &own, sizeof own), "interface " + interface);
  check(bind(socket_fd, reinterpret_cast<const sockaddr*>(&group), sizeof group), "the port");
  check(setsockopt(socket_fd, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership), "the group");
  return socket_fd;
}

struct Datagram {
  steady_clock::time_point due;
  int to;
  std::vector<char> bytes;
};

[[noreturn]] void relay(const sockaddr_in& group, milliseconds delay, const std::array<int, 2>& ends) {
  std::array<pollfd, 2> waiting{{{ends[0], POLLIN, 0}, {ends[1], POLLIN, 0}}};
  std::deque<Datagram> under_way;
  std::vector<char> buffer(kLargestDatagram);
  while (true) {
    int wait_ms = -1;
    if (!under_way.empty()) {
      const auto left = std::chrono::ceil<milliseconds>(under_way.front().due - steady_clock::now());
      wait_ms = static_cast<int>(std::max(left, milliseconds(0)).count());
    }
    poll(waiting.data(), waiting.size(), wait_ms);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      ssize_t size = 0;
      while ((size = recv(ends[i], buffer.data(), buffer.size(), MSG_DONTWAIT)) > 0) {
        under_way.push_back({steady_clock::now() + delay, ends[1 - i], {buffer.data(), buffer.data() + size}});
      }
    }
    while (!under_way.empty() && under_way.front().due <= steady_clock::now()) {
      const Datagram& next = under_way.front();
      sendto(next.to, next.bytes.data(), next.bytes.size(), 0, reinterpret_cast<const sockaddr*>(&group), sizeof group);
      under_way.pop_front();
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: delay-relay GROUP PORT DELAY_MS ADDRESS_A ADDRESS_B\n");
    return 2;
  }
  try {
    sockaddr_in group{};
    group.sin_family = AF_INET;
    group.sin_addr = address_of(argv[1]);
    group.sin_port = htons(static_cast<std::uint16_t>(std::atoi(argv[2])));
    relay(group, milliseconds(std::atoi(argv[3])), {open_end(group, argv[4]), open_end(group, argv[5])});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "delay-relay: %s\n", error.what());
    return 1;
  }
}
