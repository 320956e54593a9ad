#include "common/bus/network_check.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "common/bus/bus_url.hpp"

namespace markservo::bus {

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

bool raw_frames_fit(const std::string& url) {
  if (!is_udpm(url)) return true;
  const std::string key = "recv_buf_size=";
  const std::size_t at = url.find(key);
  if (at == std::string::npos) return false;
  const std::int64_t asked = std::strtoll(url.c_str() + at + key.size(), nullptr, 10);
  if (asked < kReceiveBufferForRawFrames) return false;
  const auto granted = granted_receive_buffer(asked);
  return granted && *granted >= kReceiveBufferForRawFrames;
}

std::string raw_frames_advice() {
  return "net.core.rmem_max is below 2 MB: frames go as JPEG; for raw frames run: sysctl -w net.core.rmem_max=4194304";
}

std::string multicast_route_advice() {
  return "is there a multicast route? On a host without network run: ip link set lo multicast on; "
         "ip route add 224.0.0.0/4 dev lo";
}

}  // namespace markservo::bus
