// A bad cable: passes the datagrams of one multicast group on between two network interfaces, each way, some time after
// they came; some of them later than what came after them, some a second time. For tests, where the kernel cannot do
// that itself.
// usage: delay-relay GROUP PORT ADDRESS_A ADDRESS_B DELAY_MS LATE_PERCENT COPY_EVERY
//   ADDRESS_*     of its own two interfaces
//   LATE_PERCENT  of the datagrams come 5 to 50 ms later still
//   COPY_EVERY    each so-many-th JOINT_STATE and WHEEL_ODOMETRY comes again 30 ms after itself; 0: none
// Runs until it is told to end.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
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
  int to;
  std::vector<char> bytes;
};

// How bad the cable is.
struct Cable {
  milliseconds delay{0};
  int late_percent = 0;
  int copy_every = 0;
};

constexpr std::uint64_t kSeed = 1;
constexpr milliseconds kLeastLate(5);
constexpr milliseconds kMostLate(50);
constexpr milliseconds kCopyLate(30);

// The channel of an LCM message of one datagram: magic "LC02", a number, the name (lcm/udpm_util.h); empty for others.
// A bridge puts the robot's name in front.
std::string channel_of(const std::vector<char>& bytes) {
  constexpr std::size_t kHeader = 8;
  if (bytes.size() <= kHeader || std::memcmp(bytes.data(), "LC02", 4) != 0) return "";
  const auto end = std::find(bytes.begin() + kHeader, bytes.end(), '\0');
  const std::string name(bytes.begin() + kHeader, end);
  return name.substr(name.rfind('/') + 1);
}

class Relay {
 public:
  Relay(const sockaddr_in& group, const Cable& cable, const std::array<int, 2>& ends)
      : group_(group), cable_(cable), ends_(ends) {}

  [[noreturn]] void run() {
    std::array<pollfd, 2> waiting{{{ends_[0], POLLIN, 0}, {ends_[1], POLLIN, 0}}};
    while (true) {
      poll(waiting.data(), waiting.size(), wait_ms());
      for (std::size_t i = 0; i < ends_.size(); ++i) take(ends_[i], ends_[1 - i]);
      pass_on();
    }
  }

 private:
  int wait_ms() const {
    if (under_way_.empty()) return -1;
    const auto left = std::chrono::ceil<milliseconds>(under_way_.begin()->first - steady_clock::now());
    return static_cast<int>(std::max(left, milliseconds(0)).count());
  }

  void take(int from, int to) {
    ssize_t size = 0;
    while ((size = recv(from, buffer_.data(), buffer_.size(), MSG_DONTWAIT)) > 0) {
      const Datagram datagram{to, {buffer_.data(), buffer_.data() + size}};
      const auto due = steady_clock::now() + cable_.delay;
      under_way_.emplace(due + lateness(), datagram);
      if (copied(datagram)) under_way_.emplace(due + kCopyLate, datagram);
    }
  }

  milliseconds lateness() {
    if (std::uniform_int_distribution<int>(0, 99)(random_) >= cable_.late_percent) return milliseconds(0);
    return milliseconds(std::uniform_int_distribution<long>(kLeastLate.count(), kMostLate.count())(random_));
  }

  bool copied(const Datagram& datagram) {
    if (cable_.copy_every == 0) return false;
    const std::string channel = channel_of(datagram.bytes);
    if (channel != "JOINT_STATE" && channel != "WHEEL_ODOMETRY") return false;
    return ++heard_[channel] % cable_.copy_every == 0;
  }

  void pass_on() {
    while (!under_way_.empty() && under_way_.begin()->first <= steady_clock::now()) {
      const Datagram& next = under_way_.begin()->second;
      sendto(next.to, next.bytes.data(), next.bytes.size(), 0, reinterpret_cast<const sockaddr*>(&group_),
             sizeof group_);
      under_way_.erase(under_way_.begin());
    }
  }

  sockaddr_in group_;
  Cable cable_;
  std::array<int, 2> ends_;
  std::vector<char> buffer_ = std::vector<char>(kLargestDatagram);
  std::mt19937_64 random_{kSeed};
  std::map<std::string, int> heard_;                             // by channel
  std::multimap<steady_clock::time_point, Datagram> under_way_;  // by when they are due
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 8) {
    std::fprintf(stderr, "usage: delay-relay GROUP PORT ADDRESS_A ADDRESS_B DELAY_MS LATE_PERCENT COPY_EVERY\n");
    return 2;
  }
  try {
    sockaddr_in group{};
    group.sin_family = AF_INET;
    group.sin_addr = address_of(argv[1]);
    group.sin_port = htons(static_cast<std::uint16_t>(std::atoi(argv[2])));
    const Cable cable{milliseconds(std::atoi(argv[5])), std::atoi(argv[6]), std::atoi(argv[7])};
    Relay(group, cable, {open_end(group, argv[3]), open_end(group, argv[4])}).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "delay-relay: %s\n", error.what());
    return 1;
  }
}
