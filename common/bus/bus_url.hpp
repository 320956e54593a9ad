#pragma once

#include <cstddef>
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
// The value of a URL's parameter, the last of its name as liblcm has it; empty where it has none.
inline std::string parameter_of(const std::string& url, const std::string& name) {
  std::string value;
  for (std::size_t at = url.find('?'); at != std::string::npos; at = url.find('&', at + 1)) {
    const std::size_t begin = at + 1 + name.size() + 1;
    if (url.compare(at + 1, name.size() + 1, name + "=") == 0) value = url.substr(begin, url.find('&', begin) - begin);
  }
  return value;
}

// A log to be written, in place of one to be read. What its path is called tells nothing: it would be emptied.
inline bool is_written_file(const std::string& url) {
  return is_file(url) && parameter_of(url, "mode") == "w";
}
inline bool is_udpm(const std::string& url) {
  return url.rfind("udpm://", 0) == 0;
}

inline bool is_memq(const std::string& url) {
  return url.rfind("memq://", 0) == 0;
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
