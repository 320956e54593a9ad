#pragma once

// Channels as LCM subscribes them: by regular expressions, anchored at both ends.

#include <string>

namespace markservo::bus {

// The one that matches `channel` alone.
std::string expression_of(const std::string& channel);

// Two that share all channels (of `robot`, where it is not empty) between them: each channel matches one of them.
struct AllChannels {
  std::string large;   // the table's large ones, behind a prefix or none: those of other robots too
  std::string others;  // all else
};
AllChannels all_channels(const std::string& robot);

}  // namespace markservo::bus
