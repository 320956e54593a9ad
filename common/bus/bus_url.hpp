#pragma once

#include <string>

namespace markservo::bus {

// The default LCM group, kept on this host (ttl 0), with a receive buffer that raw frames need.
inline constexpr const char* kDefaultUrl = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";

// Where a service reads and writes. Replaying a log needs two: "file://in.lcm?speed=0" and "file://out.lcm?mode=w".
struct BusUrls {
  std::string in = kDefaultUrl;
  std::string out = kDefaultUrl;
};

inline bool is_file(const std::string& url) {
  return url.rfind("file://", 0) == 0;
}
// A log to be written, in place of one to be read.
inline bool is_written_file(const std::string& url) {
  return is_file(url) && url.find("mode=w") != std::string::npos;
}
inline bool is_udpm(const std::string& url) {
  return url.rfind("udpm://", 0) == 0;
}

inline bool is_tcpq(const std::string& url) {
  return url.rfind("tcpq://", 0) == 0;
}

// The path in a file:// URL.
inline std::string file_path(const std::string& url) {
  const std::string path = url.substr(std::string("file://").size());
  return path.substr(0, path.find('?'));
}

}  // namespace markservo::bus
