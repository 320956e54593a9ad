#include "common/bus/network_check.hpp"

#include <cstdlib>
#include <fstream>

#include "common/bus/bus_url.hpp"

namespace markservo::bus {

std::optional<int64_t> kernel_receive_buffer_limit() {
  std::ifstream file("/proc/sys/net/core/rmem_max");
  int64_t bytes = 0;
  if (file >> bytes) return bytes;
  return std::nullopt;
}

bool raw_frames_fit(const std::string& url) {
  if (!is_udpm(url)) return true;
  const std::string key = "recv_buf_size=";
  const std::size_t at = url.find(key);
  if (at == std::string::npos) return false;
  const int64_t asked = std::strtoll(url.c_str() + at + key.size(), nullptr, 10);
  const auto limit = kernel_receive_buffer_limit();
  // Inside a network namespace the file is hidden but the limit of the host still holds; ask for what the URL says.
  return asked >= kReceiveBufferForRawFrames && (!limit || *limit >= kReceiveBufferForRawFrames);
}

std::string raw_frames_advice() {
  return "net.core.rmem_max is below 2 MB: frames go as JPEG; for raw frames run: sysctl -w net.core.rmem_max=4194304";
}

std::string multicast_route_advice() {
  return "is there a multicast route? On a host without network run: ip link set lo multicast on; "
         "ip route add 224.0.0.0/4 dev lo";
}

}  // namespace markservo::bus
