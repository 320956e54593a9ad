#include "common/bus/reachability.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/bus/network_check.hpp"

namespace markservo::bus {
namespace {

using Kind = Reachability::Kind;

class Socket {
 public:
  explicit Socket(int type) : fd_(socket(AF_INET, type | SOCK_CLOEXEC, 0)) {}
  ~Socket() {
    if (fd_ >= 0) close(fd_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  int fd() const { return fd_; }

 private:
  int fd_;
};

// liblcm needs six descriptors for a bus, and closes the standard input when it gets fewer.
bool has_free_descriptors() {
  constexpr std::size_t kNeeded = 8;
  std::vector<int> taken;
  while (taken.size() < kNeeded) {
    const int fd = dup(STDERR_FILENO);
    if (fd < 0 && errno != EMFILE && errno != ENFILE) break;  // no standard error: nothing is proven
    if (fd < 0) {
      for (const int each : taken) close(each);
      return false;
    }
    taken.push_back(fd);
  }
  for (const int each : taken) close(each);
  return true;
}

struct Address {
  std::string host;
  int port = 0;
};

// "HOST:PORT" of the URL, or the provider's own where the URL leaves it out; nothing where it is no such address.
std::optional<Address> address_of(const std::string& url, const Address& by_default) {
  const std::size_t begin = url.find("://") + 3;
  const std::string text = url.substr(begin, url.find('?') - begin);
  if (text.empty()) return by_default;
  const std::size_t colon = text.find(':');
  Address address{text.substr(0, colon), by_default.port};
  if (colon == std::string::npos) return address;
  char* end = nullptr;
  const std::string digits = text.substr(colon + 1);
  const long port = std::strtol(digits.c_str(), &end, 0);
  if (digits.empty() || *end != '\0' || port < 1 || port > 65535) return std::nullopt;
  address.port = static_cast<int>(port);
  return address;
}

std::string why(const std::string& what) {
  return what + " (" + std::strerror(errno) + ")";
}

// What errno says of a step that failed.
Reachability failed(const std::string& what) {
  switch (errno) {
    case ENETUNREACH:
    case ENETDOWN:
    case EHOSTUNREACH:
    case EHOSTDOWN:
    case EADDRNOTAVAIL:
    case ENODEV:
    case ECONNREFUSED:
    case ETIMEDOUT:
    case EPERM:  // a firewall
    case EACCES:
    case ENOBUFS:
      return {Kind::kMissing, why(what)};
    default:
      return {Kind::kNever, why(what)};
  }
}

Reachability no_route(const std::string& what) {
  Reachability found = failed(what);
  if (found.kind == Kind::kMissing) found.reason += "; " + multicast_route_advice();
  return found;
}

// The datagram of liblcm's own test: magic, number, channel, text.
std::vector<char> self_test() {
  static constexpr std::string_view kChannel = "LCM_SELF_TEST";
  std::vector<char> datagram{'L', 'C', '0', '2', 0, 0, 0, 0};
  datagram.insert(datagram.end(), kChannel.begin(), kChannel.end());
  datagram.push_back('\0');
  const std::string text = "bus self test of process " + std::to_string(getpid());
  datagram.insert(datagram.end(), text.begin(), text.end());
  return datagram;
}

// Whether what is sent to the group comes back.
bool comes_back(int fd, const sockaddr_in& group) {
  using std::chrono::milliseconds;
  using std::chrono::steady_clock;
  constexpr milliseconds kRepeat{100};
  constexpr int kTries = 3;
  const std::vector<char> sent = self_test();
  for (int i = 0; i < kTries; ++i) {
    if (sendto(fd, sent.data(), sent.size(), 0, reinterpret_cast<const sockaddr*>(&group), sizeof group) < 0) {
      return false;
    }
    const auto end = steady_clock::now() + kRepeat;
    for (auto left = kRepeat; left.count() > 0;
         left = std::chrono::duration_cast<milliseconds>(end - steady_clock::now())) {
      pollfd waiting{fd, POLLIN, 0};
      if (::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) break;
      std::array<char, 128> heard{};
      const ssize_t size = recv(fd, heard.data(), heard.size(), MSG_DONTWAIT);
      if (size == static_cast<ssize_t>(sent.size()) && std::equal(sent.begin(), sent.end(), heard.begin())) return true;
    }
  }
  return false;
}

Reachability reach_group(const std::string& url, bool listens) {
  const auto address = address_of(url, {"239.255.76.67", 7667});
  sockaddr_in group{};
  group.sin_family = AF_INET;
  const bool valid =
      address && inet_aton(address->host.c_str(), &group.sin_addr) != 0 && IN_MULTICAST(ntohl(group.sin_addr.s_addr));
  if (!valid) {
    return {Kind::kNever, "no multicast address; allowed: udpm://GROUP:PORT, GROUP from 224.0.0.0 to 239.255.255.255"};
  }
  group.sin_port = htons(static_cast<std::uint16_t>(address->port));
  Socket socket(SOCK_DGRAM);
  if (socket.fd() < 0) return failed("no socket");
  Socket route(SOCK_DGRAM);
  const auto* raw_address = reinterpret_cast<const sockaddr*>(&group);
  if (connect(route.fd(), raw_address, sizeof group) < 0) return no_route("no route to " + address->host);
  const int on = 1;
  setsockopt(socket.fd(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (listens && bind(socket.fd(), raw_address, sizeof group) < 0) {
    return failed("port " + std::to_string(address->port) + " cannot be bound");
  }
  ip_mreq membership{};
  membership.imr_multiaddr = group.sin_addr;
  membership.imr_interface.s_addr = htonl(INADDR_ANY);
  if (setsockopt(socket.fd(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) < 0) {
    return no_route("group " + address->host + " cannot be joined");
  }
  const unsigned char stay_on_host = 0;
  setsockopt(socket.fd(), IPPROTO_IP, IP_MULTICAST_TTL, &stay_on_host, sizeof stay_on_host);
  errno = 0;
  if (!listens || comes_back(socket.fd(), group)) return {};
  if (errno != 0 && errno != EAGAIN && errno != EINTR) return no_route("nothing can be sent to " + address->host);
  return {Kind::kDeaf, "what is sent to " + address->host + " does not come back; does a firewall drop it?"};
}

// As connect(), but no longer than kPatience: the kernel alone goes on for two minutes where a host drops packets.
bool connect_soon(int fd, const addrinfo& to) {
  constexpr int kPatience_ms = 500;
  const int flags = fcntl(fd, F_GETFL);
  if (fd < 0 || fcntl(fd, F_SETFL, flags | O_NONBLOCK) < 0) return false;
  if (connect(fd, to.ai_addr, to.ai_addrlen) == 0) return true;
  if (errno != EINPROGRESS) return false;
  pollfd waiting{fd, POLLOUT, 0};
  const int ready = ::poll(&waiting, 1, kPatience_ms);
  if (ready == 0) errno = ETIMEDOUT;
  if (ready <= 0) return false;
  int error = 0;
  socklen_t size = sizeof error;
  if (getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) < 0) return false;
  errno = error;
  return error == 0;
}

Reachability reach_server(const std::string& url) {
  const auto address = address_of(url, {"127.0.0.1", 7700});
  if (!address) return {Kind::kNever, "no address; allowed: tcpq://HOST:PORT"};
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(address->host.c_str(), std::to_string(address->port).c_str(), &hints, &found) != 0) {
    return {Kind::kNever, "host " + address->host + " is unknown; allowed: tcpq://HOST:PORT"};
  }
  Socket socket(SOCK_STREAM);
  const bool answers = connect_soon(socket.fd(), *found);
  const int error = errno;
  freeaddrinfo(found);
  errno = error;
  if (answers) return {};
  return failed("no LCM server at " + address->host + ":" + std::to_string(address->port));
}

}  // namespace

Reachability reach(const std::string& url, bool listens) {
  if (!is_udpm(url) && !is_tcpq(url)) return {};
  if (!has_free_descriptors()) {
    return {Kind::kNever, "no file descriptors are left; allowed: some 10 free ones (ulimit -n)"};
  }
  return is_udpm(url) ? reach_group(url, listens) : reach_server(url);
}

}  // namespace markservo::bus
