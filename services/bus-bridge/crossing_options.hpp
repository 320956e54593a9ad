#pragma once

// What crosses between a host's own bus and the link to another host, and what may not be asked for.

#include <cstddef>
#include <string>
#include <vector>

namespace markservo::bus_bridge {

struct Crossing {
  std::string link_url;
  std::vector<std::string> send;     // channels from the host's bus to the link
  std::vector<std::string> receive;  // and from the link to the host's bus
  // Bytes. A message of many packets is lost when one of them is: 8% of 9 KB messages at 1% loss, 71% of 71 KB.
  std::size_t largest = 9000;
};

// Throws ConfigurationError (what, value, allowed) for: no link or one that is no udpm:// URL; no channel at all; a
// channel that is not upper-case letters, digits and _; one named twice in a list; and, as the table of channels says,
// one whose messages are too large for a link, or one in both lists that one alone may write.
void check(const Crossing& crossing);

// Throws ConfigurationError for a host's bus `local_url` that is no udpm:// URL, and for a link on its port: LCM tells
// buses apart by their port, and both would be one bus.
void check_beside(const Crossing& crossing, const std::string& local_url);

}  // namespace markservo::bus_bridge
