#pragma once

// The channels as lines of text.

#include <string>
#include <vector>

#include "common/watch/bus_watch.hpp"

namespace markservo::bus_top {

struct ChannelLine {
  std::string channel;
  std::string text;
  bool stale = false;
  bool trouble = false;  // something was lost or could not be decoded
};

struct ChannelTable {
  std::string heading;
  std::vector<ChannelLine> lines;
};

// One line a channel, by name, the columns as wide as they need. Types that are not known are shown by fingerprint
// and size.
ChannelTable channel_table(const watch::BusWatch& watch, double now);

// "1.84 MB", "614 kB", "96 B": three digits, powers of 1000.
std::string size_text(double bytes);

}  // namespace markservo::bus_top
