#include "common/bus/network_check.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

#include "common/bus/bus_url.hpp"

namespace markservo::bus {
namespace {

constexpr const char* kBufferKey = "recv_buf_size";
constexpr std::int64_t kBufferToAsk = 4'194'304;  // bytes, as the default URL does

// The URL with that parameter, in place of one of its name.
std::string with_parameter(const std::string& url, const std::string& name, const std::string& value) {
  std::string result = url.substr(0, url.find('?'));
  char separator = '?';
  for (std::size_t at = url.find('?'); at != std::string::npos; at = url.find('&', at + 1)) {
    const std::string each = url.substr(at + 1, url.find('&', at + 1) - (at + 1));
    if (each.empty() || each.compare(0, name.size() + 1, name + "=") == 0) continue;
    result += separator + each;
    separator = '&';
  }
  return result + separator + name + "=" + value;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", and ") + part;
  return text;
}

}  // namespace

std::optional<std::int64_t> granted_receive_buffer(std::int64_t asked) {
  const int socket_fd = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket_fd < 0) return std::nullopt;
  const int wanted = static_cast<int>(std::min<std::int64_t>(asked, std::numeric_limits<int>::max() / 2));
  int granted = 0;
  socklen_t size = sizeof granted;
  const bool told = setsockopt(socket_fd, SOL_SOCKET, SO_RCVBUF, &wanted, sizeof wanted) == 0 &&
                    getsockopt(socket_fd, SOL_SOCKET, SO_RCVBUF, &granted, &size) == 0;
  close(socket_fd);
  if (!told) return std::nullopt;
  return granted / 2;  // the kernel doubles what it grants, for its own bookkeeping
}

std::string raw_frames_obstacle(const std::string& url, std::optional<std::int64_t> grantable) {
  if (!is_udpm(url)) return {};
  const std::string given = parameter_of(url, kBufferKey);
  const std::int64_t asked = std::strtoll(given.c_str(), nullptr, 10);
  std::vector<std::string> faults;
  std::vector<std::string> cures;
  if (asked < kReceiveBufferForRawFrames) {
    faults.push_back(given.empty() ? "the bus's address asks for no receive buffer"
                                   : "the bus's address asks for a receive buffer of " + given + " bytes");
    cures.push_back("use --lcm-url '" + with_parameter(url, kBufferKey, std::to_string(kBufferToAsk)) + "'");
  }
  if (!grantable) {
    faults.emplace_back("no socket is to be had to ask the kernel for its receive buffer");
  } else if (*grantable < kReceiveBufferForRawFrames) {
    faults.push_back("the kernel grants receive buffers of at most " + std::to_string(*grantable) +
                     " bytes (net.core.rmem_max)");
    cures.push_back("run: sysctl -w net.core.rmem_max=" + std::to_string(kBufferToAsk));
  }
  if (faults.empty()) return {};
  const std::string need = "; raw frames need " + std::to_string(kReceiveBufferForRawFrames);
  return joined(faults) + need + (cures.empty() ? "" : ": " + joined(cures));
}

std::string raw_frames_obstacle(const std::string& url) {
  return is_udpm(url) ? raw_frames_obstacle(url, granted_receive_buffer(kBufferToAsk)) : std::string();
}

bool raw_frames_fit(const std::string& url) {
  return raw_frames_obstacle(url).empty();
}

std::string jpeg_notice(const std::string& obstacle) {
  return "frames go as JPEG: " + obstacle;
}

std::string multicast_route_advice() {
  return "is there a multicast route? On a host without network run: ip link set lo multicast on; "
         "ip route add 224.0.0.0/4 dev lo";
}

}  // namespace markservo::bus
